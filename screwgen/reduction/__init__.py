"""Bodies from finite elements: their files, what these mean, and the reduction of meshes."""

INTERFACES = ("free", "fixed", "natural")
"""What the tip of the modes of a mesh that is reduced does; the first is the default."""
