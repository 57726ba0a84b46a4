"""Random robots with everything at once against the oracle; `python tests/mixed_arms.py 0 300` judges more of them."""

import pytest
from conftest import swept
from mixed_arms import EVERY, LAYOUTS, drawn


@pytest.mark.parametrize("seed", swept(range(24), 3, 5))
def test_a_random_robot_equals_the_oracle_in_every_back_end(seed, tmp_path):
    case = drawn(seed, tmp_path)
    layout = LAYOUTS[seed // EVERY % 2] if seed % EVERY == 0 else None
    assert max(case.judged(layout).values()) <= case.tolerance
