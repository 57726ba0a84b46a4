"""Functional mock-up units: the generated C behind the functions of FMI 2.0 and 3.0, in one archive."""
