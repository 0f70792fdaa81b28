//! End-to-end tests: through fmi-rs in `fmi_rs.rs`, through FMPy in `test_*.py`;
//! random scenes in `random/`; benchmarks in `goals.rs`. `run.py` sets up and runs everything.

pub mod unpacked;
