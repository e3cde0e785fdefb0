"""Hypothesis settings: no time limits, and the same examples in every run."""

from hypothesis import HealthCheck, settings

settings.register_profile(
    "orishell",
    deadline=None,
    derandomize=True,
    print_blob=True,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile("orishell")
