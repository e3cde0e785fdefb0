"""Types of arrays by what they hold; their shapes are given in the docstrings."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Booleans = NDArray[np.bool_]
Complex = NDArray[np.complex128]
Integers = NDArray[np.int64]
