//! Settings: how long, how finely, and by which method.

use super::SceneReader;
use solaris_model::text::{Fields, Node};
use solaris_modes::{Guard, Method, Rule, Settings};

/// Frames a second where the scene says nothing.
const RATE: f64 = 120.0;
const METHODS: [&str; 8] = [
    "Automatic",
    "Impulses",
    "RungeKutta4",
    "ExplicitEuler",
    "SemiImplicitEuler",
    "ConstantAcceleration",
    "Adaptive",
    "Stiff",
];

/// What there is to say of a step that is longer than a frame.
pub(super) fn cut(settings: &Settings) -> Option<String> {
    let (Method::Fixed { step, .. } | Method::Impulses { step }) = settings.method else { return None };
    let frame = settings.rate.recip();
    (step > frame * (1.0 + 1e-9)).then(|| {
        format!(
            "steps end at frames: a step of {step} s is cut to {frame:.3e} s, for {} frames a second",
            settings.rate
        )
    })
}

impl SceneReader<'_> {
    /// The settings; a walk lasts as long as it is.
    pub(super) fn settings(&mut self, fields: &Fields<'_, '_>, walk: Option<f64>) -> Option<Settings> {
        let duration = match (fields.get("duration"), walk) {
            (None, Some(walk)) => Some(walk),
            // Without a figure a walk has no length yet.
            (None, None) if fields.get("walk").is_some() => None,
            _ => {
                let node = self.reader.required(fields, "duration", "3.0");
                node.and_then(|node| self.reader.positive(node, "the duration", "s"))
            }
        };
        let rate = fields
            .get("rate")
            .map_or(Some(RATE), |node| self.reader.positive(node, "the rate", "frames a second"));
        let method = self.method(fields);
        self.check_method(fields, method);
        let guard = fields.get("guard").map_or(Some(Guard::default()), |node| self.guard(node));
        Some(Settings { method: method?, guard: guard?, ..Settings::new(duration?, rate?) })
    }

    /// The field `tolerance`, or the field `method`.
    fn method(&mut self, fields: &Fields<'_, '_>) -> Option<Method> {
        let tolerance = fields.get("tolerance");
        let tolerance = tolerance.map(|node| (node, self.reader.positive(node, "the tolerance", "rad or m")));
        let Some(node) = fields.get("method") else {
            let Some((_, tolerance)) = tolerance else { return Some(Method::Usual) };
            return Some(Method::Automatic { tolerance: tolerance? });
        };
        if let Some((node, _)) = tolerance {
            let message = "the tolerance decides the method; remove tolerance or method";
            self.reader.fault(node.span.clone(), message);
        }
        let kind = self.reader.kind(node, &METHODS)?;
        let rule = match kind {
            "RungeKutta4" => Rule::RungeKutta4,
            "ExplicitEuler" => Rule::ExplicitEuler,
            "SemiImplicitEuler" => Rule::SemiImplicitEuler,
            "ConstantAcceleration" => Rule::ConstantAcceleration,
            "Impulses" => {
                let fields = self.reader.fields(node, &METHODS, &["step"])?;
                let step = self.reader.required(&fields, "step", "1e-3")?;
                return Some(Method::Impulses { step: self.reader.positive(step, "the step", "s")? });
            }
            _ => {
                let fields = self.reader.fields(node, &METHODS, &["tolerance"])?;
                let tolerance = self.reader.required(&fields, "tolerance", "1e-8")?;
                let tolerance = self.reader.positive(tolerance, "the tolerance", "")?;
                return Some(match kind {
                    "Adaptive" => Method::Adaptive { tolerance },
                    "Stiff" => Method::Stiff { tolerance },
                    _ => Method::Automatic { tolerance },
                });
            }
        };
        let fields = self.reader.fields(node, &METHODS, &["step"])?;
        let step = self.reader.required(&fields, "step", "1e-3")?;
        Some(Method::Fixed { rule, step: self.reader.positive(step, "the step", "s")? })
    }

    /// Links that touch each other need steps by impulses.
    fn check_method(&mut self, fields: &Fields<'_, '_>, method: Option<Method>) {
        let touch = self.simulation.as_ref().is_some_and(|simulation| simulation.collisions().is_some());
        if !touch || matches!(method, None | Some(Method::Usual | Method::Impulses { .. })) {
            return;
        }
        if let Some(node) = fields.get("method").or(fields.get("tolerance")) {
            let message = "links that touch each other need steps by impulses; write method: Impulses(step: 1e-3), or leave this out";
            self.reader.fault(node.place(), message);
        }
    }

    /// `Guard(gimbal: deg(0.3), condition: 1e14, energy: 0.2, evaluations: 1e7)`
    fn guard(&mut self, node: &Node<'_>) -> Option<Guard> {
        let known = ["gimbal", "condition", "energy", "evaluations"];
        let fields = self.reader.fields(node, &["Guard"], &known)?;
        let before = self.reader.count();
        let mut guard = Guard::default();
        if let Some(gimbal) = fields.get("gimbal").and_then(|node| self.reader.angle(node, "gimbal")) {
            guard.gimbal = gimbal;
        }
        let mut number = |field| fields.get(field).and_then(|node| self.reader.positive(node, field, ""));
        guard.condition = number("condition").unwrap_or(guard.condition);
        guard.energy = number("energy").unwrap_or(guard.energy);
        guard.evaluations = number("evaluations").map_or(guard.evaluations, |count| count as u64);
        (self.reader.count() == before).then_some(guard)
    }
}
