"""Random tasks on five robots: a plan that arrives, or a refusal by the limit that forbids it."""

import pytest
from conftest import swept
from random_plans import drawn, outcome


@pytest.mark.parametrize("seed", swept(range(100), 1, 4, 5, 6, 9, 11, 13, 15, 22, 25, 28, 36, 54, 81))
def test_a_task_has_a_plan_that_arrives_or_is_refused_by_what_forbids_it(seed):
    result = outcome(drawn(seed))
    assert result.kind != "failed", result.words


@pytest.mark.parametrize("seed", swept(range(20), 0, 1))
def test_a_task_of_elastic_drives_has_a_plan_or_is_refused_by_what_forbids_it(seed):
    result = outcome(drawn(seed, "geared"))
    assert result.kind != "failed", result.words
