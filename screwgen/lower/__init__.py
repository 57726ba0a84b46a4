"""From mathematics with meaning to straight-line programs without."""
