"""Names of code: what another name of an object changes, and what it leaves."""

from c2s_engine import driving
from c2s_engine.structure.names import renamed

CODE = '''\
van = new Car  # the van

behavior Follow(van, gap=(1, 2)):
    do Drive(van)

behavior Own(headway=2):
    do Follow(van, headway=van.speed)
    take Say("van", scene.van)

def other(x,
          y=2):
    return van + x(van=van)
van.speed
'''


def test_comments_strings_attributes_arguments_and_parameters_stay():
    assert renamed(CODE, {"van": "lead", "headway": "gap"}) == '''\
lead = new Car  # the van

behavior Follow(van, gap=(1, 2)):
    do Drive(van)

behavior Own(headway=2):
    do Follow(lead, headway=lead.speed)
    take Say("van", scene.van)

def other(x,
          y=2):
    return lead + x(van=lead)
lead.speed
'''


def test_code_that_cannot_be_read_stays():
    assert renamed("van = (", {"van": "lead"}) == "van = ("


def test_a_parameter_of_the_library_that_is_called_as_a_function_stays_one():
    program = f"from {driving.MODULE} import junctions as c2s_junctions, reach as c2s_reach\n"
    one_file = driving.inlined(program)
    reach = one_file[one_file.index("def c2s_reach") :]
    assert "junctions=False" in reach[:80] and "ahead, junctions)" in reach[:250]
    compile(one_file[one_file.index("def c2s_reach") :].split("\ndef ")[0], "one", "exec")
