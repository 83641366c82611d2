"""The log of a bench with arms and no robot."""

import json

import jsonschema
import pytest
from logbook import messages, saved

from soccersim import Simulation, load_scenario


@pytest.fixture(scope="module")
def arms():
    return Simulation(load_scenario("arm-table2", settings=["duration=0.4"])).run()


def test_links_and_joints_are_told_where_there_are_no_robots(arms, tmp_path):
    data = saved(arms, tmp_path)
    told = list(messages(data, "/joints"))
    assert len(told) == len(arms.tick)
    schema, *_, last = told[-1]
    assert schema.name == "foxglove.JointStates"
    jsonschema.Draft202012Validator(json.loads(schema.data)).validate(last)
    assert last["joints"][3]["name"] == "arm_10_8_6/joint_1"
    angles = [joint["position"] for joint in last["joints"]]
    assert angles == pytest.approx(arms.arrays["joint"][-1].ravel(), abs=1e-8)
    lies = next(messages(data, "/tf"))[3]["transforms"]
    assert [each["child_frame_id"] for each in lies[:2]] == ["arm_8_5_3/link_1", "arm_8_5_3/link_2"]
