"""Compiled functions are what their Python is, whoever calls them."""

from soccersim.kernel import kernel, settled

LARGE = 2**60  # a float of this size has no ones


@kernel
def successor(x):
    return x + 1


def test_a_settled_kernel_answers_each_of_its_users_by_his_own_types():
    reals, wholes = settled(successor), settled(successor)
    for _ in range(2):  # the first call looks at the types, the second one need not
        assert reals(1.5) == 2.5
        assert wholes(LARGE) == LARGE + 1
