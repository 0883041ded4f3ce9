//! OpenSim's functions of one coordinate, as curves.

use super::element::{child_number, words};
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
            spline(reader, node, owner, Ends::FourPoints)
        }
        "PiecewiseLinearFunction" => spline(reader, node, owner, Ends::Straight),
        "GCVSpline" => {
            // A natural cubic; the default is a quintic.
            let half = child_number(reader, node, "half_order").unwrap_or(3.0);
            let variance = child_number(reader, node, "error_variance").unwrap_or(0.0);
            if (half - 2.0).abs() > 0.0 || variance.abs() > 0.0 {
                let degree = 2.0 * half - 1.0;
                let message = format!(
                    "{owner}: a <GCVSpline> of degree {degree} and error variance {variance} is not read, only one of \
                     degree 3 (half_order 2) and variance 0; replace it by a <SimmSpline>"
                );
                reader.fault(tag(node), message);
                return None;
            }
            spline(reader, node, owner, Ends::Natural)
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

fn spline(reader: &mut Reader, node: Node, owner: &str, ends: Ends) -> Option<Curve> {
    let (x, y) = (list(reader, node, "x", owner, 2), list(reader, node, "y", owner, 2));
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
    let curve = through(&x, &y, ends);
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
