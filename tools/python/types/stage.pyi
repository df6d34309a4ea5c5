# The types of asperity.stage: each function returns a stage of what its tool returns.
# pyright: reportPrivateUsage=false
from typing import Literal, Unpack, overload

import pandas as pd

from . import Document, Stage, _Data, _Dataset, _Quantity, _Surface, _Surfaces
