"""The paper's Section 7 run again: its two-link arm, its numbers, its figures. Started by examples/ella_paper.py."""
