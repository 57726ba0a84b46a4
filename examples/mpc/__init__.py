"""Model-predictive control of ELLA on the generated CasADi functions, against a plant in generated C."""
