"""Records are frozen dataclasses, whose ``__init__`` is written when the first one is made."""

import copy
import inspect
import pickle
from dataclasses import FrozenInstanceError, field, fields, replace
from functools import cached_property

import pytest

from orishell.conventions.record import record


@record
class Point:
    """Two numbers."""

    x: float
    y: float = 0.0
    near: list[float] = field(default_factory=list)


@record
class Named(Point):
    """A point with a name, which is checked."""

    name: str = "A"

    def __post_init__(self) -> None:
        """Refuse no name."""
        if not self.name:
            raise ValueError("no name")

    @cached_property
    def size(self) -> float:
        """Its distance from the origin."""
        return float(abs(complex(self.x, self.y)))


def test_it_is_made_by_place_and_by_name() -> None:
    point = Named(3.0, y=4.0)
    assert (point.x, point.y, point.near, point.name, point.size) == (3.0, 4.0, [], "A", 5.0)
    assert Point(1.0).near is not Point(1.0).near
    assert replace(point, x=0.0).size == 4.0
    assert [each.name for each in fields(Named)] == ["x", "y", "near", "name"]
    match point:
        case Named(x, y):
            assert (x, y) == (3.0, 4.0)


@pytest.mark.parametrize("kind", [Point, Named])
def test_what_does_not_fit_is_refused(kind: type[Point]) -> None:
    with pytest.raises(TypeError, match=rf"{kind.__name__}.__init__\(\) missing 1 required"):
        kind()  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="unexpected keyword argument 'z'"):
        kind(1.0, z=2.0)  # type: ignore[call-arg]
    with pytest.raises(ValueError, match="no name"):
        Named(1.0, name="")


@pytest.mark.parametrize("point", [Point(1.0, 2.0, [3.0]), Named(1.0, near=[3.0], name="B")])
def test_it_cannot_be_changed_but_copied(point: Point) -> None:
    with pytest.raises(FrozenInstanceError, match="'x'"):
        point.x = 2.0  # type: ignore[misc]
    with pytest.raises(FrozenInstanceError, match="'x'"):
        del point.x
    for twin in (copy.copy(point), copy.deepcopy(point), pickle.loads(pickle.dumps(point))):
        assert repr(twin) == repr(point)
        assert type(twin) is type(point)
        assert twin != point


def test_its_signature_is_known_before_one_is_made() -> None:
    @record
    class Unmade:
        """Nothing makes it."""

        x: float
        y: float = 0.0

    assert str(inspect.signature(Unmade)) == "(x: float, y: float = 0.0) -> None"
