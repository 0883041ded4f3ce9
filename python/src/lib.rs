//! The extension module of the Python package `solaris`: its classes and functions over the crate `solaris`, and no formula.

mod analysis;
mod arrays;
mod arrow;
mod chair;
mod dynamics;
mod errors;
mod figure;
mod motion;
mod profile;
mod report;
mod running;
mod scene;
mod subject;
mod walk;
mod walker;
mod written;

use pyo3::prelude::*;

/// Everything that Python sees; `solaris/__init__.py` names what is public.
#[pymodule]
mod _solaris {
    #[pymodule_export]
    use crate::analysis::{
        Ground, Inverse, Kinematics, differentiate, ground_forces, inverse_dynamics, inverse_kinematics,
    };
    #[pymodule_export]
    use crate::chair::{Chair, chair};
    #[pymodule_export]
    use crate::dynamics::Dynamics;
    #[pymodule_export]
    use crate::figure::{Figure, human, read_figure};
    #[pymodule_export]
    use crate::motion::{Motion, read_motion};
    #[pymodule_export]
    use crate::profile::Profile;
    #[pymodule_export]
    use crate::running::Running;
    #[pymodule_export]
    use crate::scene::{Run, Scene, read_scene, run};
    #[pymodule_export]
    use crate::subject::{Subject, scale};
    #[pymodule_export]
    use crate::walk::{Walk, manners, people_curves, run_gait, style_parameters, walk};
    #[pymodule_export]
    use crate::walker::Walker;
}
