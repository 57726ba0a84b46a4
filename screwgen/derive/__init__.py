"""The derivation: from the kinematics of a link class to its blocks, in sympy."""
