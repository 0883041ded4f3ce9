//! OpenSim's functions of one coordinate, as curves.

use super::element::{child_number, child_words, words};
use super::quintic;
use super::spline::{Ends, through};
use crate::xml::{Node, Reader, element, elements, shown, tag};
use solaris_model::Curve;

/// The most points or coefficients of one function.
const MOST: usize = 100_000;

/// The function that `holder` holds beside the elements called `others`: an element of any other name, in an element
/// `function` or not. Nothing where there is none.
pub(super) fn held<'a>(holder: Node<'a>, others: &[&str]) -> Option<Node<'a>> {
    let found = elements(holder).find(|child| !others.contains(&child.tag_name().name()))?;
    let wraps = found.tag_name().name() == found.tag_name().name().to_lowercase();
    if wraps { elements(found).next() } else { Some(found) }
}

/// The curve of a function, which belongs to `owner`; nothing where it cannot be one, which is a fault.
pub(super) fn read(reader: &mut Reader, mut node: Node, owner: &str) -> Option<Curve> {
    let mut scale = 1.0;
    while node.tag_name().name() == "MultiplierFunction" {
        if element(node, "scale").is_some() {
            scale *= child_number(reader, node, "scale")?;
        }
        let Some(inner) = held(node, &["scale"]) else {
            reader.fault(tag(node), format!("{owner}: the <MultiplierFunction> holds no function"));
            return None;
        };
        node = inner;
    }
    let curve = plain(reader, node, owner)?;
    // One changes no bit.
    Some(curve.scaled(scale))
}

/// The curve of a function that is no multiple of another.
fn plain(reader: &mut Reader, node: Node, owner: &str) -> Option<Curve> {
    match node.tag_name().name() {
        "Constant" => {
            let value = element(node, "value").map_or(Some(0.0), |value| reader.text_number(value))?;
            Some(Curve::Polynomial(vec![value]))
        }
        "LinearFunction" => {
            let coefficients = element(node, "coefficients");
            let [slope, offset] = match coefficients.filter(|node| !words(*node).is_empty()) {
                Some(node) => reader.text_numbers(node, 2..=2)?.try_into().ok()?,
                None => [1.0, 0.0],
            };
            Some(Curve::linear(slope, offset))
        }
        // The file has the highest power first.
        "PolynomialFunction" => {
            let mut coefficients = list(reader, node, "coefficients", owner, 1)?;
            coefficients.reverse();
            Some(Curve::Polynomial(coefficients))
        }
        "SimmSpline" | "NaturalCubicSpline" | "natCubicSpline" => {
            cubics(reader, node, owner, Ends::FourPoints)
        }
        "PiecewiseLinearFunction" => cubics(reader, node, owner, Ends::Straight),
        "GCVSpline" => {
            // The default is the quintic.
            let half = child_number(reader, node, "half_order").unwrap_or(3.0);
            let variance = child_number(reader, node, "error_variance").unwrap_or(0.0);
            match half {
                _ if variance.abs() > 0.0 => {}
                2.0 => return cubics(reader, node, owner, Ends::Natural),
                3.0 => return spline(reader, node, owner, 6, quintic::through),
                _ => {}
            }
            let degree = 2.0 * half - 1.0;
            let message = format!(
                "{owner}: a <GCVSpline> of degree {degree} and error variance {variance} is not read, only those of degree 3 \
                 and 5 (half_order 2 and 3) and variance 0; replace it by a <SimmSpline>"
            );
            reader.fault(tag(node), message);
            None
        }
        "Sine" => {
            let mut number = |name, absent| match element(node, name) {
                Some(child) => reader.text_number(child),
                None => Some(absent),
            };
            let (amplitude, frequency) = (number("amplitude", 1.0), number("omega", 1.0));
            let (phase, offset) = (number("phase", 0.0), number("offset", 0.0));
            Some(Curve::Sine { amplitude: amplitude?, frequency: frequency?, phase: phase?, offset: offset? })
        }
        // One coordinate: the lowest power first.
        "MultivariatePolynomialFunction" if child_words(node, "dimension") == Some("1") => {
            list(reader, node, "coefficients", owner, 1).map(Curve::Polynomial)
        }
        other => {
            let message = format!(
                "{owner}: the function <{}> is not read; replace it by a <SimmSpline> through some of its values",
                shown(other)
            );
            reader.fault(tag(node), message);
            None
        }
    }
}

fn cubics(reader: &mut Reader, node: Node, owner: &str, ends: Ends) -> Option<Curve> {
    spline(reader, node, owner, 2, |x, y| through(x, y, ends))
}

/// The spline that `through` makes of the points of a function, `fewest` at least.
fn spline(
    reader: &mut Reader,
    node: Node,
    owner: &str,
    fewest: usize,
    through: impl Fn(&[f64], &[f64]) -> Curve,
) -> Option<Curve> {
    let (x, y) = (list(reader, node, "x", owner, fewest), list(reader, node, "y", owner, fewest));
    let (x, y) = (x?, y?);
    let name = node.tag_name().name();
    if x.len() != y.len() {
        let message = format!("{owner}: the <{name}> has {} x and {} y; give as many", x.len(), y.len());
        reader.fault(tag(node), message);
        return None;
    }
    if let Some([before, after]) = x.array_windows().find(|[before, after]| before >= after) {
        let message = format!("{owner}: the <{name}> has x = {after} after {before}; x must rise");
        reader.fault(tag(node), message);
        return None;
    }
    let curve = through(&x, &y);
    // Abscissae or values as far apart as numbers reach.
    let finite = x.iter().all(|x| curve.at(*x).iter().all(|value| value.is_finite()));
    if !finite {
        reader.fault(tag(node), format!("{owner}: the points of the <{name}> give no finite curve"));
        return None;
    }
    Some(curve)
}

/// The numbers of a child element, `fewest` at least.
fn list(reader: &mut Reader, node: Node, name: &str, owner: &str, fewest: usize) -> Option<Vec<f64>> {
    let Some(child) = element(node, name) else {
        reader.fault(tag(node), format!("{owner}: the <{}> has no <{name}>", node.tag_name().name()));
        return None;
    };
    reader.text_numbers(child, fewest..=MOST)
}
