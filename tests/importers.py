"""One crane through the importers of others.

`python importers.py IMPORTER INTERFACE FMU ANGLES RESULT` opens an FMU, sets
`theta_1` to each of the angles (a JSON list, in rad), one step of 1 s for each,
and writes what every real input and output then is into the file RESULT, as
JSON. A process of its own each time: some importers crash.
"""

import ctypes
import json
import sys
from pathlib import Path

from fmpy import extract, read_model_description


def fmpy(fmu, thetas, model_exchange):
    from fmpy.fmi2 import FMU2Model, FMU2Slave
    from fmpy.fmi3 import FMU3Model, FMU3Slave

    description = read_model_description(fmu)
    fmi3 = description.fmiVersion.startswith("3")
    kinds = (FMU3Model, FMU3Slave) if fmi3 else (FMU2Model, FMU2Slave)
    interface = description.modelExchange if model_exchange else description.coSimulation
    crane = kinds[not model_exchange](guid=description.guid, unzipDirectory=extract(fmu), instanceName="crane",
                                      modelIdentifier=interface.modelIdentifier)
    crane.instantiate()
    if not fmi3:
        crane.setupExperiment(startTime=0.0)
    crane.enterInitializationMode()
    crane.exitInitializationMode()
    write, read = (crane.setFloat64, crane.getFloat64) if fmi3 else (crane.setReal, crane.getReal)
    if model_exchange:
        (crane.updateDiscreteStates if fmi3 else crane.newDiscreteStates)()
        crane.enterContinuousTimeMode()
    references = reals(description)
    for i, theta in enumerate(thetas):
        write([references["theta_1"]], [theta])
        if model_exchange:
            crane.setTime(float(i + 1))
        else:
            crane.doStep(currentCommunicationPoint=float(i), communicationStepSize=1.0)
        yield dict(zip(references, read(list(references.values()))))
    crane.terminate()
    crane.freeInstance()


def fmuloader(fmu, thetas, model_exchange):
    from fmuloader.fmi2 import Fmi2Slave, Fmi2Type
    from fmuloader.fmi3 import Fmi3Slave

    description = read_model_description(fmu)
    references = reals(description)
    fmi3 = description.fmiVersion.startswith("3")
    crane = (Fmi3Slave if fmi3 else Fmi2Slave)(fmu, model_identifier=description.modelName)
    if not fmi3:
        kind = Fmi2Type.MODEL_EXCHANGE if model_exchange else Fmi2Type.CO_SIMULATION
        crane.instantiate("crane", kind, guid=description.guid)
        crane.setup_experiment(start_time=0.0)
    elif model_exchange:
        crane.instantiate_model_exchange("crane", instantiation_token=description.guid)
    else:
        crane.instantiate_co_simulation("crane", instantiation_token=description.guid)
    crane.enter_initialization_mode()
    crane.exit_initialization_mode()
    write, read = (crane.set_float64, crane.get_float64) if fmi3 else (crane.set_real, crane.get_real)
    if model_exchange:
        (crane.update_discrete_states if fmi3 else crane.new_discrete_states)()
        crane.enter_continuous_time_mode()
    for i, theta in enumerate(thetas):
        write([references["theta_1"]], [theta])
        if model_exchange:
            crane.set_time(float(i + 1))
        else:
            crane.do_step(float(i), 1.0)
        yield dict(zip(references, read(list(references.values()))))
    crane.terminate()
    crane.free_instance()


def ecos(fmu, thetas):
    # Its library wants libtbb.so.12, which the package tbb puts beside the interpreter.
    if sys.platform == "linux":
        ctypes.CDLL(str(Path(sys.prefix) / "lib/libtbb.so.12"), ctypes.RTLD_GLOBAL)
    from ecospy.EcosSimulation import EcosSimulation
    from ecospy.EcosSimulationStructure import EcosSimulationStructure

    names = list(reals(read_model_description(fmu)))
    with EcosSimulationStructure() as structure:
        structure.add_model("crane", fmu)
        with EcosSimulation(step_size=1.0, structure=structure) as simulation:
            assert simulation.init()
            for theta in thetas:
                simulation.set_real("crane::theta_1", theta)
                simulation.step()
                yield {name: simulation.get_real(f"crane::{name}") for name in names}
            simulation.terminate()


def libcosim(fmu, thetas):
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimManipulator import CosimManipulator
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    execution = CosimExecution.from_step_size(1_000_000_000)
    crane = execution.add_local_slave(CosimLocalSlave(fmu, "crane"))
    inputs, outputs = CosimManipulator.create_override(), CosimObserver.create_last_value()
    execution.add_manipulator(inputs)
    execution.add_observer(outputs)
    references = reals(read_model_description(fmu))
    for theta in thetas:
        inputs.slave_real_values(crane, [references["theta_1"]], [theta])
        assert execution.step()
        yield dict(zip(references, outputs.last_real_values(crane, list(references.values()))))


def reals(description):
    """Value references of the real inputs and outputs that are one number each: not every importer knows vectors."""
    return {v.name: v.valueReference for v in description.modelVariables
            if v.causality in ("input", "output") and v.type in ("Real", "Float64") and not v.dimensions}


DRIVERS = {
    ("FMPy", "CS"): lambda fmu, thetas: fmpy(fmu, thetas, model_exchange=False),
    ("FMPy", "ME"): lambda fmu, thetas: fmpy(fmu, thetas, model_exchange=True),
    ("fmuloader", "CS"): lambda fmu, thetas: fmuloader(fmu, thetas, model_exchange=False),
    ("fmuloader", "ME"): lambda fmu, thetas: fmuloader(fmu, thetas, model_exchange=True),
    ("ecospy", "CS"): ecos,
    ("libcosimpy", "CS"): libcosim,
}

if __name__ == "__main__":
    importer, interface, path, angles, result = sys.argv[1:]
    rows = list(DRIVERS[importer, interface](path, json.loads(angles)))
    Path(result).write_text(json.dumps(rows))
