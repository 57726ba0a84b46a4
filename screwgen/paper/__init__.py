"""The paper, checked: its printed equations as data, what became of each, and a judge that moves an arm."""
