"""The back ends: one file each, none knows another."""
