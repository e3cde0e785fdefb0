"""The motion in closed form: rotations of panels, fold rates, accelerations, shapes."""
