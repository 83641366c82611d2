"""Numbers over time as a replay page holds them: few letters, and they come back."""

import re
import zlib

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from unpacked import read, unspelt

from soccersim.render.page.pack import Packer, deflated, spelt

numbers = st.floats(-1e4, 1e4) | st.just(np.nan)
tables = st.tuples(st.integers(1, 20), st.integers(1, 3)).flatmap(
    lambda shape: st.tuples(arrays(float, shape, elements=numbers), arrays(float, shape))
)


@given(tables, st.sampled_from((0.001, 0.005, 0.05, 1.0)), st.integers(0, 2))
def test_every_number_comes_back_within_half_a_step(pair, step, order):
    values, below = pair[0], np.nan_to_num(pair[1], posinf=1e3, neginf=-1e3).clip(-1e3, 1e3)
    packer = Packer(len(values))
    packer.add("below", below, 0.25)
    packer.add("values", values, step, order, on="below")
    _, found = read(packer.packed({}))
    assert np.array_equal(np.isnan(found["values"]), np.isnan(values))
    assert np.nanmax(np.abs(found["values"] - values), initial=0) <= step / 2 * 1.001 + 1e-9
    assert np.abs(found["below"] - below).max() <= 0.125


@given(arrays(float, st.tuples(st.integers(1, 6), st.integers(1, 3))))
def test_even_absurd_numbers_are_packed(values):
    packer = Packer(len(values))
    packer.add("values", values, 1e-3)
    _, found = read(packer.packed({}))
    assert np.isfinite(found["values"]).tolist() == np.isfinite(values).tolist()


@given(st.binary(max_size=300))
def test_bytes_spelt_in_letters_come_back_and_never_end_a_script(data):
    letters = spelt(data)
    assert unspelt(letters) == data
    assert re.fullmatch(r"[!-;=-~]*", letters)
    assert len(letters) <= (len(data) + 4) * 16 / 13 + 2


@given(st.lists(st.binary(max_size=300), max_size=4))
def test_parts_deflated_in_different_ways_are_one_stream(parts):
    assert zlib.decompress(deflated(parts)) == b"".join(parts)


def test_noise_is_deflated_better_than_by_looking_for_repetitions():
    rng = np.random.default_rng(3)
    noise = rng.normal(20, 4, 100_000).astype(np.uint8).tobytes()
    words = b"the quick brown fox " * 1000
    assert len(deflated([noise, words])) < 0.95 * len(zlib.compress(noise + words, 9))
