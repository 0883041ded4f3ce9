//! Cases in which the formulas as printed lose their digits, or do not exist at all. The numbers that are wanted were
//! computed with more than 100 digits, from the formulas as printed with their signs corrected.

use solaris_profiles::displacement::{
    Exponential, ExponentialVelocities, Hyperbolic, Line, Power, Tension, Trigonometric,
    TrigonometricVelocities,
};
use solaris_profiles::{Answers, Curve, Elementary, ProfileError, Quantity, Stationary, Turn, legacy};

/// One line of a table: parameters, of which the last is the time, and position, velocity, acceleration and jerk.
type Row = (Vec<f64>, Vec<f64>);

/// Of lines "parameters | values".
fn rows(table: &str) -> Vec<Row> {
    let numbers = |text: &str| text.split_whitespace().map(|x| x.parse().expect("a number")).collect();
    let rows = table.lines().filter_map(|line| line.split_once('|'));
    rows.map(|(parameters, values)| (numbers(parameters), numbers(values))).collect()
}

/// |found − wanted| ≤ 8·ε·(cond + |wanted| + max |wanted|) for each of the values, where cond, t times the derivative, is what
/// the rounding of a time does.
fn check<F: Elementary>((parameters, wanted): &Row, curve: &impl Curve<F>) {
    let [t, duration] = [parameters[parameters.len() - 1], curve.duration().value()];
    let mut sizes = [0.0_f64; 4];
    for i in 0..=256 {
        let sample = curve.at_time(f64::from(i) / 256.0 * duration).to_array();
        sizes = [0, 1, 2, 3].map(|j| sizes[j].max(sample[j].value().abs()));
    }
    let found = curve.at_time(t).to_array();
    for (order, &wanted) in wanted.iter().enumerate() {
        let error = (found[order].value() - wanted).abs();
        let cond = t * found.get(order + 1).map_or(0.0, |derivative| derivative.value().abs());
        let quotient = error / (0.5 * F::EPSILON * (cond + wanted.abs() + sizes[order]));
        let found = found[order].value();
        assert!(quotient <= 8.0, "{parameters:?}, order {order}: {found:e}, not {wanted:e}: {quotient} of 8");
    }
}

/// Every row in double and in single precision.
macro_rules! check_rows {
    ($table:expr, |$row:ident, $convert:ident| $curve:expr) => {
        for row in rows($table) {
            let $row = &row.0;
            let $convert = |x: f64| x;
            check(&row, &$curve.expect("a curve"));
            let $convert = |x: f64| x as f32;
            check(&row, &$curve.expect("a curve"));
        }
    };
}

/// T = 2, from 0 to 3, close to rest: in the sine of the thesis, a displacement of 10⁻¹⁶ is lost.
#[test]
fn s1_close_to_rest() {
    fn check_relative<F: Elementary>(bound: f64) {
        let curve =
            Trigonometric::new(F::from_f64(2.0), F::from_f64(0.0), F::from_f64(3.0)).expect("a curve");
        for (parameters, wanted) in &rows(S1)[..3] {
            let found = curve.at_time(parameters[0]).to_array();
            for (found, wanted) in found.into_iter().zip(wanted) {
                let error = (found.value() / wanted - 1.0).abs();
                assert!(error <= bound, "at {parameters:?}: {found:?}, not {wanted}");
            }
        }
    }
    check_relative::<f64>(1e-15);
    check_relative::<f32>(4e-7);
    check_rows!(S1, |_row, c| Trigonometric::new(c(2.0), c(0.0), c(3.0)));
}

/// The thesis divides by the end position.
#[test]
fn s1b_to_zero_or_next_to_it() {
    fn check_end<F: Elementary>(end: f64, least: f64) {
        let [t, x0, x1] = [2.0, 0.0, end].map(F::from_f64);
        let (zero, one, three) = (F::from_f64(0.0), F::from_f64(1.0), F::from_f64(3.0));
        let half = |way: f64, curve: &dyn Curve<F>| {
            let found = curve.at(one).position.value();
            assert!((found - way * end).abs() <= least, "{found:e}, not {:e}", way * end);
            assert!(curve.at(t).to_array().iter().all(|x| x.is_finite()));
            assert!((curve.at(t).position.value() - x1.value()).abs() <= 0.0);
        };
        half(0.5, &Line::new(t, x0, x1).expect("a curve"));
        half(0.5, &Trigonometric::new(t, x0, x1).expect("a curve"));
        half(0.125, &Power::new(t, x0, x1, three).expect("a curve"));
        half(0.875, &Exponential::new(t, x0, x1, three, one).expect("a curve"));
        half(0.5, &Hyperbolic::new(t, x0, x1, zero).expect("a curve"));
        half(0.5, &TrigonometricVelocities::new(t, (x0, zero), (x1, zero)).expect("a curve"));
        half(0.5, &ExponentialVelocities::new(t, (x0, zero), (x1, zero), 3, one).expect("a curve"));
        half(0.5, &Tension::new(t, (x0, zero), (x1, zero), one).expect("a curve"));
    }
    check_end::<f64>(1e-310, 1e-322);
    check_end::<f64>(0.0, 0.0);
    check_end::<f32>(1e-42, 1e-44);
    check_end::<f32>(0.0, 0.0);
    // And from 1 to 0, which is no special case.
    assert!((Trigonometric::new(2.0, 1.0, 0.0).expect("a curve").at(1.0).position - 0.5_f64).abs() < 2e-16);
}

/// T = 2, from 0 to 5, velocities 1 + 2ⁿ and 1 (the last rows: equal ones).
#[test]
fn s2_velocities_that_are_nearly_equal() {
    check_rows!(S2, |row, c| {
        let difference = if row[0] < 0.0 { 2.0_f64.powf(row[0]) } else { 0.0 };
        // In single precision, small differences are none, which changes what is wanted by less than is allowed.
        TrigonometricVelocities::new(c(2.0), (c(0.0), c(1.0 + difference)), (c(5.0), c(1.0)))
    });
}

/// T = 2, from 1 to 4, n = 5, s = 2ⁿ.
#[test]
fn s3_a_shape_close_to_the_straight_line() {
    check_rows!(S3, |row, c| Exponential::new(c(2.0), c(1.0), c(4.0), c(5.0), c(2.0_f64.powf(row[0]))));
}

/// T = 2ⁱ, n, s, u: (T/s)ⁿ is more or less than a number can hold.
#[test]
fn s3b_large_powers_of_any_time() {
    let mut single = 0;
    for (mut parameters, wanted) in rows(S3B) {
        let duration = 2.0_f64.powf(parameters[0]);
        parameters[3] *= duration;
        let row = (parameters, wanted);
        let [n, s] = [row.0[1], row.0[2]];
        check(&row, &Exponential::new(duration, 0.0, 1.0, n, s).expect("a curve"));
        // In single precision the jerk of the shortest of these is beyond what can be held.
        if let Ok(curve) = Exponential::new(duration as f32, 0.0, 1.0, n as f32, s as f32) {
            check(&row, &curve);
            single += 1;
        }
    }
    assert!(single > 0, "no row was checked in single precision");
}

/// T = 2, from 1 to 5, velocities 1 and 2; n, s = 2ⁱ.
#[test]
fn s4_the_equations_of_the_exponential_are_nearly_singular() {
    check_rows!(S4, |row, c| {
        let shape = c(2.0_f64.powf(row[1]));
        ExponentialVelocities::new(c(2.0), (c(1.0), c(1.0)), (c(5.0), c(2.0)), row[0] as u32, shape)
    });
}

/// T = 2, from 0 to 5; n, s and the velocity at the start, 2 at the end.
#[test]
fn s4b_large_exponents() {
    check_rows!(S4B, |row, c| {
        ExponentialVelocities::new(c(2.0), (c(0.0), c(row[2])), (c(5.0), c(2.0)), row[0] as u32, c(row[1]))
    });
}

/// From 0 to 5 with velocities 1 and 2: how far it goes, which is no error of the computation.
#[test]
fn s4c_exponentials_that_swing_far_out() {
    for (n, shape, most) in
        [(20, -2.0, 38_483.0), (30, -2.0, 6.138e8), (9, 1.001, 2.421e15), (4, 2.0001, 16_873.0)]
    {
        let curve = ExponentialVelocities::new(1.0, (0.0, 1.0), (5.0, 2.0), n, shape).expect("a curve");
        let (low, high) = curve.range(Quantity::Position, 0.0, 1.0);
        let found = high.max(-low);
        assert!((found / most - 1.0).abs() < 1e-3, "n = {n}: {found}");
        let error = curve.within(100.0).expect_err("too far");
        assert!(matches!(error, ProfileError::OutOfRange { what: "largest position", .. }), "{error}");
        assert_eq!(curve.within(1.001 * most), Ok(curve));
        let single = ExponentialVelocities::<f32>::new(1.0, (0.0, 1.0), (5.0, 2.0), n, shape as f32);
        assert!(single.and_then(|curve| curve.within(100.0)).is_err());
    }
    let tame = ExponentialVelocities::new(1.0, (0.0, 1.0), (5.0, 2.0), 5, -1.0).expect("a curve");
    assert_eq!(tame.within(6.0), Ok(tame));
    let error = tame.within(4.0).expect_err("the end itself").to_string();
    assert_eq!(error, "largest position is 5; it must be at most 4");
}

/// T = 2, from 0 to 5, velocities 1 and 12; k.
#[test]
fn s5_any_stiffness() {
    check_rows!(S5, |row, c| Tension::new(c(2.0), (c(0.0), c(1.0)), (c(5.0), c(12.0)), c(row[0])));
    // The velocities at the ends die down as e⁻ᵏᵘ, on ways of (v₀ − v)·T/k and (v₁ − v)·T/k: v = (D − T·(v₀ + v₁)/k)/(T − 2·T/k).
    let curve = Tension::new(2.0, (0.0, 1.0), (5.0, 12.0), 1e4).expect("a curve");
    let middle = curve.at(1.0);
    let slope = (5.0 - 26.0 / 1e4) / (2.0 - 4.0 / 1e4);
    assert!((middle.velocity - slope).abs() < 8.0 * f64::EPSILON, "{} {slope}", middle.velocity);
    assert!(middle.acceleration.abs() < 1e-300 && curve.at(2.0).acceleration > 4e4);
    // The durations for which the thesis's basis fails, with k = T.
    for duration in [0.9999, 1.0 - 1e-8, 1.0, 2.827_181_75, 2.827_181_757_169_648, 711.0, 1e4, 1e-8] {
        let curve = Tension::new(duration, (0.0, 1.0), (5.0, 1.0), duration).expect("a curve");
        let (low, high) = curve.range(Quantity::Position, 0.0, duration);
        // It stays near the way between its ends however long it lasts.
        assert!(
            low > -0.1 && high < 5.1 && (curve.at(0.5 * duration).position - 2.5).abs() < 1e-13,
            "{low}..{high}"
        );
    }
    assert!(legacy::Hyperbolic::new(0.9999, (0.0, 1.0), (5.0, 1.0)).is_ok());
    assert!(legacy::Hyperbolic::new(1.0, (0.0, 1.0), (5.0, 1.0)).is_err());
}

/// Both unit systems describe the same motion, unlike in the thesis's basis.
#[test]
fn shapes_do_not_depend_on_the_unit_of_time() {
    for scale in [1e-9, 1e-3, 1.0, 60.0, 1e9] {
        let (v0, v1) = (-1.0 / scale, -5.0 / scale);
        let curves: [Box<dyn Curve>; 3] = [
            Box::new(TrigonometricVelocities::new(2.0 * scale, (0.0, v0), (5.0, v1)).expect("a curve")),
            Box::new(
                ExponentialVelocities::new(2.0 * scale, (0.0, v0), (5.0, v1), 6, -0.5).expect("a curve"),
            ),
            Box::new(Tension::new(2.0 * scale, (0.0, v0), (5.0, v1), 3.0).expect("a curve")),
        ];
        let wanted: [Box<dyn Curve>; 3] = [
            Box::new(TrigonometricVelocities::new(2.0, (0.0, -1.0), (5.0, -5.0)).expect("a curve")),
            Box::new(ExponentialVelocities::new(2.0, (0.0, -1.0), (5.0, -5.0), 6, -0.5).expect("a curve")),
            Box::new(Tension::new(2.0, (0.0, -1.0), (5.0, -5.0), 3.0).expect("a curve")),
        ];
        for (curve, wanted) in curves.iter().zip(&wanted) {
            for t in [0.0, 0.3, 1.0, 1.9] {
                let (found, wanted) = (curve.at(t * scale).to_array(), wanted.at(t).to_array());
                for (order, (found, wanted)) in found.into_iter().zip(wanted).enumerate() {
                    let found = found * scale.powi(order as i32);
                    assert!(
                        (found - wanted).abs() <= 1e-13 * (1.0 + wanted.abs()),
                        "{order}: {found}, not {wanted}"
                    );
                }
            }
        }
    }
    // The thesis's does: 1.649 half way in seconds, 1.514 in minutes.
    let middle = |minute: f64| {
        let curve =
            legacy::Hyperbolic::new(2.0 / minute, (0.0, minute), (5.0, 5.0 * minute)).expect("a curve");
        curve.at(1.0 / minute).position
    };
    assert!((middle(1.0) - 1.648_573_734_3).abs() < 1e-9 && (middle(60.0) - 1.514_343_853_3).abs() < 1e-9);
}

#[test]
fn from_a_place_to_itself_all_stand_still() {
    let still: [Box<dyn Answers>; 8] = [
        Box::new(Line::new(2.0, 1.0, 1.0).expect("a curve")),
        Box::new(Trigonometric::new(2.0, 1.0, 1.0).expect("a curve")),
        Box::new(Power::new(2.0, 1.0, 1.0, 1.5).expect("a curve")),
        Box::new(Exponential::new(2.0, 1.0, 1.0, 4.0, 3.0).expect("a curve")),
        Box::new(Hyperbolic::new(2.0, 1.0, 1.0, 5.0).expect("a curve")),
        Box::new(TrigonometricVelocities::new(2.0, (1.0, 0.0), (1.0, 0.0)).expect("a curve")),
        Box::new(ExponentialVelocities::new(2.0, (1.0, 0.0), (1.0, 0.0), 6, 0.5).expect("a curve")),
        Box::new(Tension::new(2.0, (1.0, 0.0), (1.0, 0.0), 5.0).expect("a curve")),
    ];
    for curve in &still {
        assert_eq!(curve.stationary(), Stationary::everywhere(2.0));
        assert!(curve.is_monotone());
        for t in [0.0, 0.7, 1.3, 2.0] {
            let sample = curve.at(t).to_array();
            assert!(
                (sample[0] - 1.0).abs() <= 0.0 && sample[1..].iter().all(|x| x.abs() <= 0.0),
                "{sample:?}"
            );
        }
    }
    let legacy = legacy::Hyperbolic::new(2.0, (1.0, 0.0), (1.0, 0.0)).expect("a curve");
    assert_eq!(legacy.stationary(), Stationary::everywhere(2.0));
}

#[test]
fn very_long_and_very_short_motions_are_as_good() {
    for duration in [1e-9, 1e9] {
        let v = 3.0 / duration;
        let curve = Tension::new(duration, (0.0, -v), (1.0, v), 7.0).expect("a curve");
        let wanted = Tension::new(1.0, (0.0, -3.0), (1.0, 3.0), 7.0).expect("a curve");
        assert_eq!((curve.stationary().points.len(), wanted.stationary().points.len()), (1, 1));
        for (found, wanted) in curve.stationary().points.iter().zip(&wanted.stationary().points) {
            assert!((found.time / duration - wanted.time).abs() < 1e-15 && found.turn == wanted.turn);
        }
        assert!(Trigonometric::new(duration as f32, 0.0, 1.0).is_ok());
    }
    // Too short for its own jerk.
    let error = Trigonometric::new(1e-200, 0.0, 1.0).expect_err("too short");
    assert!(matches!(error, ProfileError::Overflow { .. }), "{error}");
    assert!(Trigonometric::<f32>::new(1e-20, 0.0, 1.0).is_err());
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let text = |error: ProfileError| error.to_string();
    let nan = f64::NAN;
    let refused = [
        (text(Line::new(0.0, 0.0, 1.0).expect_err("none")), "duration 0: it must be more than zero"),
        (text(Line::new(nan, 0.0, 1.0).expect_err("none")), "duration is NaN; it must be a finite number"),
        (text(Line::new(1.0, nan, 1.0).expect_err("none")), "from is NaN; it must be a finite number"),
        (
            text(Trigonometric::new(1.0, 0.0, f64::INFINITY).expect_err("none")),
            "to is inf; it must be a finite number",
        ),
        (text(Power::new(1.0, 0.0, 1.0, 0.5).expect_err("none")), "exponent is 0.5; it must be at least 1"),
        (
            text(Hyperbolic::new(1.0, 0.0, 1.0, -1.0).expect_err("none")),
            "stiffness is -1; it must be at least 0",
        ),
        (
            text(Exponential::new(1.0, 0.0, 1.0, 4.0, 2.0).expect_err("none")),
            "shape is 2: with an even exponent the motion comes back to where it began; it may be less than 2, or more than 2",
        ),
        (
            text(Exponential::new(1.0, 0.0, 1.0, 2.5, 1.5).expect_err("none")),
            "shape is 1.5: with an exponent that is not whole, time must not pass the power's own zero; it may be at most 1",
        ),
        (
            text(ExponentialVelocities::new(1.0, (0.0, nan), (1.0, 0.0), 5, 0.5).expect_err("none")),
            "start velocity is NaN; it must be a finite number",
        ),
        (
            text(ExponentialVelocities::new(1.0, (0.0, 0.0), (1.0, 0.0), 2, 0.5).expect_err("none")),
            "exponent is 2; it must be at least 3 and at most 100",
        ),
        (
            text(ExponentialVelocities::new(1.0, (0.0, 0.0), (1.0, 0.0), 4, 2.0).expect_err("none")),
            "shape is 2: with an even exponent above 3 no motion reaches its end; it may be less than 2, or more than 2",
        ),
        (
            text(ExponentialVelocities::new(1.0, (0.0, 0.0), (1.0, 0.0), 5, 1.0).expect_err("none")),
            "shape is 1: with an exponent above 3 the velocity at the end is always zero; \
             it may be less than 1, or more than 1",
        ),
        (
            text(Tension::new(1.0, (0.0, 0.0), (1.0, nan), 1.0).expect_err("none")),
            "end velocity is NaN; it must be a finite number",
        ),
        (
            text(Tension::new(1.0, (0.0, 0.0), (1.0, 0.0), nan).expect_err("none")),
            "stiffness is NaN; it must be a finite number",
        ),
    ];
    for (found, wanted) in refused {
        assert_eq!(found, wanted);
    }
    // The thesis holds this one impossible.
    assert!(ExponentialVelocities::new(1.0, (0.0, 0.0), (1.0, 1.0), 3, 2.0).is_ok());
}

#[test]
fn touches_are_told_from_reversals() {
    // v = (1 − 2u)²·…, exactly: the cubic from 0 to 1/3 with velocities 1 and 1.
    let touch = Tension::new(1.0, (0.0, 1.0), (1.0 / 3.0, 1.0), 0.0).expect("a curve").stationary();
    assert_eq!(touch.points.len(), 1);
    assert!((touch.points[0].time - 0.5).abs() < 1e-15 && touch.points[0].turn == Turn::Touch);
}

const S1: &str = "
    0.001953125 | 7.0592856357427326298e-6 0.0072287028210487752705 3.7010842323193647137 -0.017836109294197513686
    1.490116119384765625e-8 | 4.109048268761693948e-16 5.5150712287552791001e-8 3.7011016504085084682 -1.360789281791109987e-7
    8.8817841970012523234e-16 | 1.459827199128118783e-30 3.287238615009355308e-15 3.7011016504085094821 -8.110936175531805228e-15
    1.9999997615814208984 | 2.9999999999998948084 8.8241139660082410941e-7 -3.7011016504082499321 -2.177262850865725283e-6
";

const S2: &str = "
    -20 0.0625 | 0.069722967252397380042 1.230948323950919838 3.6832785900484673574 -0.56984097207402353993
    -20 1.0 | 2.5000003035639631117 3.3561942180154465472 -7.490140565847857567e-7 -5.8136750294381089462
    -20 1.75 | 4.6358193320236073277 1.9016763444883167409 -3.419371262202330904 -2.2247960279314850869
    -33 0.0625 | 0.069722909998694501286 1.23094744609609367 3.6832798341959172925 -0.56983998245896672829
    -33 1.0 | 2.5000000000370561478 3.3561944901591202098 -9.143237995419748006e-11 -5.813676877330615928
    -33 1.75 | 4.6358192987709897872 1.9016765947959605434 -3.4193720624584661633 -2.2247978219457479663
    -47 0.0625 | 0.069722909991705097258 1.2309474459889271157 3.6832798343478000313 -0.56983998233815673495
    -47 1.0 | 2.5000000000000022617 3.356194490192342901 -5.580589596813811039e-15 -5.8136768775562025133
    -47 1.75 | 4.635819298766930382 1.9016765948265175409 -3.4193720625561596429 -2.2247978221647572161
    0 0.0625 | 0.069722909991704670633 1.2309474459889205744 3.6832798343478093021 -0.56983998233814936084
    0 1.0 | 2.5 3.3561944901923449288 0.0 -5.8136768775562162829
    0 1.75 | 4.6358192987669301342 1.9016765948265194061 -3.419372062556165606 -2.2247978221647705842
";

const S3: &str = "
    -13 0.0625 | 1.09377217555007954 1.5003433620024995209 -0.000366296163422864 6.707108656076071507e-8
    -13 1.0 | 2.5001831166442796891 1.4999999888227648168 -0.000366233287877132 6.7063411074369593224e-8
    -13 1.75 | 3.625080109864426017 1.4997253327178656938 -0.000366182992621371 6.7057271001487244545e-8
    -27 0.0625 | 1.093750001353328126 1.5000000209547580751 -2.235174210822588273e-8 2.498001841466507304e-16
    -27 1.0 | 2.500000011175870937 1.4999999999999999584 -2.235174187403821091e-8 2.498001824018166033e-16
    -27 1.75 | 3.6250000048894435213 1.4999999832361936231 -2.235174168668807463e-8 2.498001810059493059e-16
    -40 0.0625 | 1.0937500000001652012 1.5000000000025579538 -2.728484105323515152e-12 3.722312756495183795e-24
    -40 1.0 | 2.5000000000013642421 1.5 -2.728484105320025484e-12 3.722312756492009960e-24
    -40 1.75 | 3.6250000000005968559 1.4999999999979536369 -2.728484105317233750e-12 3.722312756489470892e-24
";

const S3B: &str = "
    -10 100 3.0 0.125 | -7.888609052210118054e-31 -1.501562321387325693e-45 7.306674330862153415e-40
    -10 100 3.0 0.625 | -7.888596526402538111e-31 4.397632101209660611e-31 1.528506349344790471e-25
    -10 100 3.0 0.9375 | 0.000053064241145426 8.9938399337240994983 1509119.2007523547212
    20 60 3.0 0.125 | -8.673617379879126386e-19 -1.348322790151353119e-34 3.641557828625328096e-38
    20 60 3.0 0.625 | -8.670742078049106464e-19 5.640894538740134084e-26 1.088211422900612676e-29
    20 60 3.0 0.9375 | 0.0027219564645650446381 2.5779574880755625283e-7 2.400883512243728992e-11
    -20 60 3.0 0.125 | -8.673617379879126386e-19 -1.482496585766792329e-22 4.402373282644944096e-14
    -20 60 3.0 0.625 | -8.670742078049106464e-19 6.20222913640291352e-14 0.000013155668863441
    -20 60 3.0 0.9375 | 0.0027219564645650446381 283449.42340512898652 29024900678384.996521
    20 60 0.5 0.125 | 0.97918978419247344989 6.3507738670430148239e-7 -1.905800670143320081e-11
    20 60 0.5 0.625 | 0.99999999982766950005 7.171512984575989822e-15 -2.934676195248575380e-19
    20 60 0.5 0.9375 | 0.99999999999999996791 1.774839076110317784e-21 -9.399010646192550594e-26
    -10 100 -2.0 0.125 | 9.525237843756057735e-39 1.560614968638895383e-33 2.531342448971786533e-28
    -10 100 -2.0 0.625 | 3.207202185381503814e-13 2.919266700293919916e-8 0.0026306096089688571147
    -10 100 -2.0 0.9375 | 0.014179451471469327114 1010.0701430806671976 71232605.791266586309
";

const S4: &str = "
    5 -7 0.0625 | 1.0663667246858863217 1.1227363900941613086 1.9158513779463627109 -1.5330498034534050401
    5 -7 1.0 | 2.7514647261106924499 2.2499977054769387055 0.49414109555723020057 -1.4999724657232644659
    5 -7 1.75 | 4.4729362783425837011 2.2012043664647999204 -0.62097071252637378473 -1.473684835884119058
    5 -13 0.0625 | 1.0663455504767984918 1.1220807062894364013 1.9063998489963873454 -1.5005150068839128632
    5 -13 1.0 | 2.7500228881831502881 2.2499999994411837329 0.49990844726739884778 -1.4999999932942047943
    5 -13 1.75 | 4.4726606308610854152 2.2030949597027390838 -0.62493705718200255758 -1.4995880248575486254
    5 -40 0.0625 | 1.0663452148437525006 1.1220703125000774381 1.9062500000011164403 -1.5000000000038369308
    5 -40 1.0 | 2.7500000000001705303 2.25 0.49999999999931787897 -1.5
    5 -40 1.75 | 4.4726562500000326406 2.203124999999776179 -0.62499999999953104179 -1.4999999999969304554
    8 -13 0.0625 | 1.0663460539327314645 1.1220962971090946392 1.9066246215241590564 -1.5012876092859455787
    8 -13 1.0 | 2.7500572169626159934 2.2499999944122925045 0.49977113215010446038 -1.499999932947510099
    8 -13 1.75 | 4.4726672008821397141 2.2030499071673157076 -0.62484265021029118851 -1.4989702162013935069
";

const S4B: &str = "
    20 -0.5 1.0 0.0625 | 0.068887645058691744361 1.2098127040364051739 3.620893422191216103 8.7179362934211448494
    20 -0.5 1.0 1.0 | 4.040581091530483308 7.8330238693792721683 4.4728939074967240568 -36.627513855756191487
    20 -0.5 1.0 1.75 | 6.5699501338139007804 -7.2878483100920235278 -27.299895261034225783 216.30475243928949988
    30 -2.0 0.0 0.0625 | 3.872821134162585820e-13 1.966314278847122434e-11 8.041584629867061363e-10 2.7378197905822406882e-8
    30 -2.0 0.0 1.0 | 0.000300664716136849 0.0042494332839314036935 0.057384950278870557013 0.7377871021902001482
    30 -2.0 0.0 1.75 | 1.2828377799816374672 10.205755274668475173 65.878846749104483252 227.49144439802796014
    40 -0.5 0.0 0.0625 | 1.9769822096718312571e-7 7.5131358189613807894e-6 0.000184777229071916 0.0026022008379054462201
    40 -0.5 0.0 1.0 | 0.017208783049127246086 0.13522771290282722329 1.0018607683829060313 6.9542287584103209359
    40 -0.5 0.0 1.75 | 2.2518516262276099872 10.691684628984026067 33.590941205249670061 -69.588363125517390788
    40 0.5 1.0 0.0625 | -16394539.326199932439 -366404940.58929771924 245327518.92150328583 113889926660.9540352
    40 0.5 1.0 1.0 | -136505.16493661360457 1456109.6122087028851 -14682438.603640732383 138330413.47425306879
    40 0.5 1.0 1.75 | -2.3631703777034897558 117.69027361855208066 -1792.1703727588588503 26343.337691440918394
    30 0.25 1.0 0.0625 | -1.1390572149026795031 -33.078698674298367502 -350.5468260038036119 5314.1951334573141799
    30 0.25 1.0 1.0 | -4.9497693733060503072 21.687562080236049062 -19.461431742541321458 -99.416637115619036328
    30 0.25 1.0 1.75 | 4.2333328510616025074 4.3964489564006721965 -12.990942122903527766 31.143412953942604827
";

const S5: &str = "
    7.450580596923828125e-9 0.0625 | 0.050292968750000000028 0.61718750000000000087 -5.7499999999999999864 11.999999999999999985
    7.450580596923828125e-9 1.0 | -0.24999999999999999682 0.50000000000000000139 5.4999999999999999873 11.999999999999999983
    7.450580596923828125e-9 1.75 | 2.5156250000000000008 7.9999999999999999947 14.500000000000000008 12.000000000000000087
    0.0009765625 0.0625 | 0.050292969223429876838 0.61718751501066400275 -5.7499997669753364263 11.999999741837384596
    0.0009765625 1.0 | -0.24999994536241025855 0.50000002384185761241 5.4999997814496419027 11.999999713897709463
    0.0009765625 1.75 | 2.5156250138805866381 7.9999999093823152086 14.500000136842325684 12.000001502037025436
    0.5 0.0625 | 0.050416321396378402234 0.62109834502438427206 -5.6892974043981043697 11.932479608123035538
    0.5 1.0 | -0.2357660389751165772 0.50622960339870269361 5.4431233495402504953 11.92530031177143044
    0.5 1.75 | 2.5192476944480848706 7.9763625528528051829 14.535557429048459227 12.392183621112311845
    1.0 0.0625 | 0.050777564603570206154 0.63254906321142708803 -5.5116716397072304227 11.731724379018236301
    1.0 1.0 | -0.19410528644080042206 0.52467672203233149213 5.2773455661710952286 11.704756293723462402
    1.0 1.75 | 2.5299277710571813965 7.9068278679929636659 14.63854416545712533 13.550294080213620445
    2.75 0.0625 | 0.053469353054587911361 0.7177424141914074522 -4.1961511140236886952 10.067511702982219892
    2.75 1.0 | 0.11450577808303064062 0.67198065425704632365 4.0853677062503266311 9.980993375606318383
    2.75 1.75 | 2.6130731599267944394 7.3736345911423535501 15.342119125912385196 22.651307850030102358
    40.0 0.0625 | 0.09709044085019647071 1.9200332882592286884 7.3888079190259583459 -147.77615838051905173
    40.0 1.0 | 2.22500000113363449 2.289473701567609454 4.5345379693648272408e-7 6.9428332545298789669e-6
    40.0 1.75 | 3.9453767137403454836 2.3549026958595396457 1.3085802329802990814 26.171604659605331205
    720.0 0.0625 | 0.15141790467417542513 2.4888579384667633873 9.0683843529137432903e-8 -0.000032646183670489
    720.0 1.0 | 2.4847222222222222222 2.4888579387186629526 1.78517871798026977e-153 4.686941744243969859e-151
    720.0 1.75 | 4.3513656762612194367 2.4888579387186629526 2.805639052273432138e-36 1.010030058818435569e-33
";

#[test]
fn what_overflows_inside_is_refused_and_never_a_position_that_is_no_number() {
    for (n, s) in [(5, -2e13), (20, -1.5e17), (4, -1e200), (4, -1e30)] {
        if let Ok(curve) = ExponentialVelocities::new(1.0_f64, (0.0, 0.0), (1.0, 0.0), n, s) {
            assert!((0..=10).all(|i| curve.at(0.1 * f64::from(i)).position.is_finite()), "n = {n}, s = {s}");
        }
        if let Ok(curve) = ExponentialVelocities::new(1.0_f32, (0.0, 0.0), (1.0, 0.0), n, s as f32) {
            assert!(
                (0..=10_u8).all(|i| curve.at(0.1 * f32::from(i)).position.is_finite()),
                "n = {n}, s = {s}"
            );
        }
    }
    assert!(ExponentialVelocities::feasible_start_velocity(1.0, 0.0, 1.0, 0.0, 100, 0.9999).is_err());
    assert!(!Power::<f32>::new(1e9, 0.0, 1e-20, 1.5).expect("a curve").at(0.0).jerk.is_nan());
}

/// With velocities of 1, 35 units ended at 10.07 instead of 5, and 40 far away.
#[test]
fn a_legacy_hyperbolic_curve_that_would_miss_its_end_is_refused() {
    for (start, end) in [((0.0, 1.0), (5.0, 1.0)), ((0.0, 0.0), (10.0, 0.0)), ((1.0, -2.0), (1.0, 3.0))] {
        let mut refused = 0;
        for duration in (3..=700).map(f64::from) {
            match legacy::Hyperbolic::new(duration, start, end) {
                Ok(curve) => {
                    let last = curve.at(duration);
                    let off = (last.position - end.0).abs().max(duration * (last.velocity - end.1).abs());
                    assert!(off < 1e-5 * (10.0 + 3.0 * duration), "{duration}: {last:?}");
                }
                Err(error) => {
                    refused += 1;
                    assert!(error.to_string().contains("misses its end"), "{duration}: {error}");
                }
            }
        }
        // Between rests nothing is lost that counts.
        let expected = if start.1.abs() > 0.0 { 600..690 } else { 0..1 };
        assert!(expected.contains(&refused), "{start:?}, {end:?}: {refused}");
    }
    for duration in [35.0, 40.0, 100.0] {
        assert!(legacy::Hyperbolic::new(duration, (0.0, 1.0), (5.0, 1.0)).is_err(), "{duration}");
    }
    assert!(legacy::Hyperbolic::<f32>::new(20.0, (0.0, 1.0), (5.0, 1.0)).is_err());
}
