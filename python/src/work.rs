//! Work in threads of its own: the caller lets other Python code run, hears Ctrl+C, and gets an exception where the work
//! panics.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::exceptions::{PyOSError, PyRuntimeError};
use pyo3::prelude::*;

/// How often it is looked whether Ctrl+C was pressed.
const LOOK: Duration = Duration::from_millis(25);

fn defect() -> PyErr {
    PyRuntimeError::new_err(
        "a mistake of the program itself, not of the scene: please report it, with the scene and the line about a panic that was \
         printed before",
    )
}

/// What `work` gives, here and now.
pub fn here<T>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T>
where
    T: Send,
{
    py.detach(|| catch_unwind(AssertUnwindSafe(work))).map_err(|_| defect())
}

/// What `work` gives on each of so many threads. It is told by a flag to stop; after Ctrl+C nobody waits for that.
pub fn shared<T: Send + 'static>(
    py: Python<'_>,
    threads: usize,
    work: impl Fn(&AtomicBool) -> T + Send + Sync + 'static,
) -> PyResult<Vec<T>> {
    let (sender, receiver) = channel();
    let (stop, work) = (Arc::new(AtomicBool::new(false)), Arc::new(work));
    let mut begun = 0;
    for _ in 0..threads {
        let (sender, stop, work) = (sender.clone(), Arc::clone(&stop), Arc::clone(&work));
        let run = move || {
            let done = catch_unwind(AssertUnwindSafe(|| work(&stop)));
            // Nobody waits any more after Ctrl+C.
            let _ = sender.send(done);
        };
        match std::thread::Builder::new().spawn(run) {
            Ok(_) => begun += 1,
            // Fewer do as well.
            Err(_) if begun > 0 => break,
            Err(error) => return Err(PyOSError::new_err(format!("cannot start a thread: {error}"))),
        }
    }
    drop((sender, work));
    let done = py.detach(move || {
        let mut found = Vec::new();
        while found.len() < begun {
            match receiver.recv_timeout(LOOK) {
                Ok(Ok(one)) => found.push(one),
                Ok(Err(_)) | Err(RecvTimeoutError::Disconnected) => return Err(defect()),
                Err(RecvTimeoutError::Timeout) => Python::attach(|py| py.check_signals())?,
            }
        }
        Ok(found)
    });
    if done.is_err() {
        stop.store(true, Ordering::Relaxed);
    }
    done
}
