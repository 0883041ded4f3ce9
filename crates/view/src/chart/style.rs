//! Styles of the classes of elements.

use std::fmt::Write as _;

/// Class, how it looks, and what is else in the dark.
type Rule = (&'static str, &'static str, &'static str);

/// The classes of a picture. `s0` to `s5` colour a line, `f0` to `f5` an area or a mark, `t0` to `t5` a text (M. Okabe, K. Ito: blue,
/// vermilion, green, purple, orange, sky blue; texts darker).
#[rustfmt::skip]
const RULES: &[Rule] = &[
    // Texts.
    ("title", "font-size:17px;font-weight:bold", ""),
    ("bold", "font-weight:bold", ""),
    ("italic", "font-style:italic", ""),
    ("soft", "fill:#555", "fill:#9aa4ad"),
    ("small", "font-size:11.5px", ""),
    ("end", "text-anchor:end", ""),
    ("middle", "text-anchor:middle", ""),
    // A text over lines, with an edge as the sheet is.
    ("over", "paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round", "stroke:#171a1e"),
    ("t0", "fill:#005a8c", "fill:#79bbee"),
    ("t1", "fill:#a34800", "fill:#f5a87b"),
    ("t2", "fill:#00684c", "fill:#5fd8b4"),
    ("t3", "fill:#8a4169", "fill:#e6a9cb"),
    ("t4", "fill:#7a5400", "fill:#f0bf4c"),
    ("t5", "fill:#1c6690", "fill:#86cdf3"),
    // The sheet and the panels.
    ("paper", "fill:#fff", "fill:#171a1e"),
    ("strip", "fill:#f3efe2", "fill:#2b2920"),
    ("rest", "fill:#eee6c8", "fill:#3a3621"),
    ("floor", "fill:#777;fill-opacity:.13", ""),
    ("fine", "fill:none;stroke:#f1f1f1;stroke-width:.6", "stroke:#20252a"),
    ("grid", "fill:none;stroke:#dedede;stroke-width:.8", "stroke:#2e353b"),
    ("zero", "fill:none;stroke:#888", "stroke:#7b858e"),
    ("box", "fill:none;stroke:#999", "stroke:#59636c"),
    ("level", "fill:none;stroke:#444;stroke-width:1.2;stroke-dasharray:5 3", "stroke:#cfd5da"),
    ("moment", "fill:none;stroke:#888;stroke-dasharray:2 3", ""),
    // Lines.
    ("line", "fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round", ""),
    ("thin", "fill:none;stroke-width:1.3;stroke-dasharray:5 3;stroke-linejoin:round", ""),
    ("broad", "fill:none;stroke-width:7;stroke-opacity:.45;stroke-linejoin:round", ""),
    ("limb", "fill:none;stroke-width:4;stroke-linejoin:round;stroke-linecap:round", ""),
    ("arm", "fill:none;stroke-width:2.5;stroke-linejoin:round;stroke-linecap:round", ""),
    ("bone", "fill:none;stroke:#c9c9c9;stroke-width:9;stroke-linecap:round", "stroke:#49525a"),
    ("jump", "fill:none;stroke-width:1.2;stroke-dasharray:1.5 2.5", ""),
    ("dots", "fill:none;stroke-width:1.8;stroke-dasharray:2 3", ""),
    ("dashes", "fill:none;stroke-width:1.6;stroke-dasharray:5 3", ""),
    ("body", "stroke:#444", "stroke:#cfd5da"),
    ("s0", "stroke:#0072b2", "stroke:#4a9fe0"),
    ("s1", "stroke:#d55e00", "stroke:#f0864a"),
    ("s2", "stroke:#009e73", "stroke:#2dc79b"),
    ("s3", "stroke:#cc79a7", ""),
    ("s4", "stroke:#e69f00", ""),
    ("s5", "stroke:#56b4e9", ""),
    // Areas and marks.
    ("f0", "fill:#0072b2", "fill:#4a9fe0"),
    ("f1", "fill:#d55e00", "fill:#f0864a"),
    ("f2", "fill:#009e73", "fill:#2dc79b"),
    ("f3", "fill:#cc79a7", ""),
    ("f4", "fill:#e69f00", ""),
    ("f5", "fill:#56b4e9", ""),
    // Bodies.
    ("left", "fill:#7fb2d6", "fill:#5b93ba"),
    ("right", "fill:#e8a57c", "fill:#cc835a"),
    ("trunk", "fill:#cbc4b8", "fill:#a39c92"),
    ("area", "fill-opacity:.25", "fill-opacity:.4"),
    ("ink", "fill:#222;stroke:#fff", "fill:#e8ebee;stroke:#171a1e"),
    ("peak", "fill:#555", "fill:#9aa4ad"),
    ("open", "fill:#fff;stroke:#222;stroke-width:1.5", "fill:#171a1e;stroke:#e8ebee"),
    ("mark", "stroke:#fff;stroke-width:.8", "stroke:#171a1e"),
    ("hollow", "fill:#fff;stroke-width:1.7", "fill:#171a1e"),
    ("failed", "fill:none;stroke-width:2", ""),
    ("arrow", "stroke-width:2", ""),
];

/// The rules of the classes that `body` has.
pub(super) fn sheet(body: &str) -> String {
    let mut classes: Vec<&str> = body
        .split("class=\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .flat_map(str::split_whitespace)
        .collect();
    classes.sort_unstable();
    classes.dedup();
    debug_assert!(
        classes.iter().all(|class| RULES.iter().any(|rule| rule.0 == *class)),
        "a class that is none: {classes:?}"
    );
    let (mut light, mut dark) = (String::new(), String::new());
    for (class, look, in_the_dark) in RULES.iter().filter(|rule| classes.binary_search(&rule.0).is_ok()) {
        // Writing to a string cannot fail.
        let _ = writeln!(light, ".solaris-chart .{class}{{{look}}}");
        if !in_the_dark.is_empty() {
            let _ = writeln!(dark, ".solaris-chart .{class}{{{in_the_dark}}}");
        }
    }
    format!(
        ".solaris-chart{{font:13px \"Helvetica Neue\",Helvetica,Arial,\"Liberation Sans\",sans-serif}}\n\
         .solaris-chart text{{fill:#222}}\n{light}\
         @media screen and (prefers-color-scheme:dark){{\n.solaris-chart text{{fill:#e8ebee}}\n{dark}}}\n"
    )
}
