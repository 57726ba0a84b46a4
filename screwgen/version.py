"""The version of the tool, stated in everything that it writes."""

__version__ = "0.1.0"
