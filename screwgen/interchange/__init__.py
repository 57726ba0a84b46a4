"""Robots in the formats of other tools: URDF read and written, and robot files as text for people."""
