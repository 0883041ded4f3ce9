//! A stretch as the crate diffsol wants its equations.

use super::super::evaluate::Evaluator;
use super::super::stepping::Course;
use super::super::{System, TimeError};
use diffsol::{
    ConstantOp, Matrix, MatrixCommon, NalgebraContext, NalgebraMat, NalgebraVec, NonLinearOp,
    NonLinearOpJacobian, OdeEquations, OdeEquationsRef, Op, UnitCallable, Vector, VectorCommon,
};
use nalgebra::DMatrix;
use std::cell::RefCell;

pub(super) type Mat = NalgebraMat<f64>;
pub(super) type Vect = NalgebraVec<f64>;

/// What is written where there is no rate: so large that every error test refuses the step, and a shorter one is tried.
/// Its square is still finite.
const NO_RATE: f64 = 1e100;

/// A stretch, whatever is stepped.
pub(super) trait Host {
    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), TimeError>;
    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), TimeError>;
    fn event_values(&mut self, t: f64, y: &[f64], values: &mut [f64]) -> Result<(), TimeError>;
    fn event_side(&self, index: usize) -> f64;
    fn settle(&self, y: &mut [f64]);
    /// Shows the state at a frame.
    fn show(&mut self, time: f64, y: &[f64]) -> Result<(), TimeError>;
}

/// A system, and who looks on.
pub(super) struct Stretch<'a, 'b, S: System + ?Sized> {
    pub(super) evaluator: Evaluator<'a, S>,
    pub(super) course: Course<'b, S>,
}

impl<S: System + ?Sized> Host for Stretch<'_, '_, S> {
    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), TimeError> {
        self.evaluator.rate(t, y, rate)
    }

    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), TimeError> {
        self.evaluator.jacobian(t, y, jacobian)
    }

    fn event_values(&mut self, t: f64, y: &[f64], values: &mut [f64]) -> Result<(), TimeError> {
        self.evaluator.event_values(t, y, values)
    }

    fn event_side(&self, index: usize) -> f64 {
        self.evaluator.system.event_side(index)
    }

    fn settle(&self, y: &mut [f64]) {
        self.evaluator.system.settle(y);
    }

    fn show(&mut self, time: f64, y: &[f64]) -> Result<(), TimeError> {
        self.course.show(self.evaluator.system, time, y)
    }
}

/// The equations of a stretch. What fails in them is kept here, for the crate's functions cannot fail.
pub(super) struct Equations<'a> {
    pub(super) host: RefCell<&'a mut dyn Host>,
    /// The last failure of an evaluation.
    failure: RefCell<Option<TimeError>>,
    /// The failure of the last Jacobian.
    without_jacobian: RefCell<Option<TimeError>>,
    start: &'a [f64],
    context: NalgebraContext,
}

impl<'a> Equations<'a> {
    pub(super) fn new(host: &'a mut dyn Host, start: &'a [f64]) -> Self {
        Self {
            host: RefCell::new(host),
            failure: RefCell::new(None),
            without_jacobian: RefCell::new(None),
            start,
            context: NalgebraContext::default(),
        }
    }

    /// The last failure since this was asked last.
    pub(super) fn take_failure(&self) -> Option<TimeError> {
        self.failure.borrow_mut().take()
    }

    /// Why there is no Jacobian, if the last one that was asked for failed.
    pub(super) fn jacobian_failure(&self) -> Option<TimeError> {
        self.without_jacobian.borrow().clone()
    }
}

impl Op for Equations<'_> {
    type T = f64;
    type V = Vect;
    type M = Mat;
    type C = NalgebraContext;

    fn context(&self) -> &NalgebraContext {
        &self.context
    }

    fn nstates(&self) -> usize {
        self.start.len()
    }

    fn nout(&self) -> usize {
        self.start.len()
    }

    fn nparams(&self) -> usize {
        0
    }
}

impl NonLinearOp for Equations<'_> {
    fn call_inplace(&self, y: &Vect, t: f64, rate: &mut Vect) {
        let rate = rate.inner_mut().as_mut_slice();
        let result = self.host.borrow_mut().rate(t, y.inner().as_slice(), rate);
        if let Err(error) = result {
            *self.failure.borrow_mut() = Some(error);
            rate.fill(NO_RATE);
        }
    }
}

impl NonLinearOpJacobian for Equations<'_> {
    fn jac_mul_inplace(&self, y: &Vect, t: f64, v: &Vect, product: &mut Vect) {
        // The implicit methods ask for the matrix; this is for whatever else may ask.
        let n = self.start.len();
        let mut matrix = Mat::zeros(n, n, self.context);
        self.jacobian_inplace(y, t, &mut matrix);
        matrix.inner().mul_to(v.inner(), product.inner_mut());
    }

    fn jacobian_inplace(&self, y: &Vect, t: f64, jacobian: &mut Mat) {
        let jacobian = jacobian.inner_mut();
        let result = self.host.borrow_mut().jacobian(t, y.inner().as_slice(), jacobian);
        if result.is_err() {
            jacobian.fill(0.0);
        }
        *self.without_jacobian.borrow_mut() = result.err();
    }
}

impl ConstantOp for Equations<'_> {
    fn call_inplace(&self, _: f64, y: &mut Vect) {
        y.inner_mut().as_mut_slice().copy_from_slice(self.start);
    }
}

impl<'b> OdeEquationsRef<'b> for Equations<'_> {
    type Mass = UnitCallable<Mat>;
    type Rhs = &'b Self;
    type Root = UnitCallable<Mat>;
    type Init = &'b Self;
    type Out = UnitCallable<Mat>;
    type Reset = UnitCallable<Mat>;
}

impl OdeEquations for Equations<'_> {
    fn rhs(&self) -> &Self {
        self
    }

    fn mass(&self) -> Option<UnitCallable<Mat>> {
        None
    }

    fn init(&self) -> &Self {
        self
    }

    fn set_params(&mut self, _: &Vect) {}

    fn get_params(&self, _: &mut Vect) {}
}
