"""Real-time control with acados of models that `model.acados()` hands over."""
