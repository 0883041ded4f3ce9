//! Whatever a text is, it is read or refused, each fault at a place of the text; what is written, others read too.

use proptest::prelude::*;
use solaris_text::layout::{Doc, field, group, number, quoted};
use solaris_text::{Content, Node, Reader, TextError, Value, did_you_mean, first_word, parse};

/// Pieces that texts are made of, and some that they are not.
const PIECES: [&str; 44] = [
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ":",
    ",",
    "\"",
    "\\",
    "\\u{",
    "/*",
    "*/",
    "//",
    "\n",
    "\r\n",
    "\t",
    " ",
    "Line",
    "deg",
    "from: ",
    "version: 1",
    "true",
    "None",
    "Some(",
    "r\"",
    "r#\"",
    "r#from",
    "#![enable(",
    "]",
    "-",
    "+1",
    "1e999",
    "-inf",
    "NaN",
    "0x",
    "1_0.5",
    ".",
    "°",
    "é",
    "膝",
    "\u{feff}",
    "\0",
    "'",
];

fn any_text() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        9 => proptest::sample::select(PIECES.to_vec()).prop_map(str::to_owned),
        1 => any::<char>().prop_map(String::from),
    ];
    proptest::collection::vec(piece, 0..60).prop_map(|pieces| pieces.concat())
}

/// Reads every node in every way; what it is, is looked at by nobody.
fn read_all(reader: &mut Reader, node: &Node<'_>) {
    reader.number(node, "it");
    reader.angle(node, "it");
    reader.bound(node, false, "it");
    reader.positive(node, "it", "m");
    reader.flag(node);
    reader.name(node, "it");
    reader.numbers(node, "it", ["x", "y"]);
    reader.list(node, "it");
    if let Some(fields) = reader.fields(node, &["Line", "Curve"], &["from", "to"]) {
        reader.is_later(&fields, "line", 1, true);
        reader.required_number(&fields, "from", "0");
        reader.number_or(&fields, "to", 1.0);
        reader.choice(&fields, "to", &["A", "B"]);
    }
    reader.entries(node, "it", "{}");
    match node.group().map(|group| &group.content) {
        Some(Content::Fields(fields)) => fields.iter().for_each(|(_, node)| read_all(reader, node)),
        Some(Content::Tuple(items) | Content::List(items)) => {
            for node in items {
                read_all(reader, node);
            }
        }
        Some(Content::Map(entries)) => entries.iter().for_each(|(key, value)| {
            read_all(reader, key);
            read_all(reader, value);
        }),
        None => {}
    }
}

fn check(text: &str, error: &TextError) {
    assert!(!error.faults.is_empty());
    for fault in &error.faults {
        assert!(text.get(fault.place.span.clone()).is_some(), "{text:?}: {fault:?}");
        assert!(fault.place.line <= text.split('\n').count() && fault.place.column > 0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn any_text_is_read_or_refused(text in any_text()) {
        first_word(&text);
        match parse(&text, "line", "Line(from: 0)") {
            Err(error) => check(&text, &error),
            Ok(tree) => {
                let mut reader = Reader::default();
                read_all(&mut reader, &tree);
                let count = reader.count();
                match reader.finish(&text) {
                    Ok(()) => prop_assert_eq!(count, 0),
                    Err(error) => {
                        check(&text, &error);
                        prop_assert_eq!(error.faults.len() + error.omitted, count);
                    }
                }
            }
        }
    }

    #[test]
    fn numbers_and_texts_come_back_as_they_were_here_and_elsewhere(bits in any::<u64>(), said in ".*") {
        let value = f64::from_bits(bits);
        let text = group("(", vec![Doc::Atom(number(value)), Doc::Atom(quoted(&said))], ")").flat();
        let tree = parse(&text, "pair", "(0, \"\")").expect("it was written");
        let [Node { value: Value::Number(read), .. }, Node { value: Value::Text(told), .. }] =
            tree.items().expect("a tuple") else { panic!("{text}") };
        prop_assert!(read.to_bits() == bits || (read.is_nan() && value.is_nan()), "{}", text);
        prop_assert_eq!(told.as_ref(), said.as_str());
        let (other, heard): (f64, String) = ron::from_str(&text).expect("it is RON");
        prop_assert!(other.to_bits() == bits || (other.is_nan() && value.is_nan()), "{}", text);
        prop_assert_eq!(heard, said);
    }
}

#[test]
fn what_others_call_ron_is_read() {
    let text = "#![enable(implicit_some)]\n/* a /* nested */ comment */ Line(r#from: +.5, to: Some(1_000), by: r#\"a \"b\"\"#,)";
    let tree = parse(text, "line", "Line(…)").expect("it is RON");
    let mut reader = Reader::default();
    let fields = reader.fields(&tree, &["Line"], &["from", "to", "by"]).expect("a line");
    let from = fields.get("from").and_then(|node| reader.number(node, "from"));
    let to = fields.get("to").and_then(|node| reader.number(node, "to"));
    let by = fields.get("by").and_then(|node| reader.text(node, "by"));
    assert_eq!((from, to, by), (Some(0.5), Some(1000.0), Some("a \"b\"")));
}

#[test]
fn faults_are_told_in_the_order_of_the_text() {
    let text =
        "Line(\n    form: 1,\n    to: deg(3),\n    at: [1, \"two\"],\n    to: 0,\n    until: Soone(),\n)";
    let tree = parse(text, "line", "Line(…)").expect("it is RON");
    let mut reader = Reader::default();
    let fields = reader.fields(&tree, &["Line"], &["from", "to", "at", "until"]).expect("a line");
    reader.required_number(&fields, "from", "0");
    reader.number_or(&fields, "to", 0.0);
    fields.get("at").and_then(|node| reader.list(node, "at"));
    reader.choice(&fields, "until", &["Never", "Soon"]);
    let said = reader.finish(text).expect_err("it is full of faults").to_string();
    assert_eq!(
        said,
        "line 1, column 1: this Line has no from; add from: 0\n\
         line 2, column 5: Line has no field 'form'; did you mean 'from'?\n\
         line 3, column 9: to is no angle; it must be a plain number, without deg(…)\n\
         line 4, column 13: a number of at must be a number, not a text\n\
         line 5, column 5: Line is given 'to' twice; keep one of them\n\
         line 6, column 12: 'Soone' is not known here; did you mean 'Soon'?"
    );
}

#[test]
fn what_fits_stands_on_a_line_and_the_rest_is_broken_at_its_commas() {
    let key = |i: u8| group("(", vec![Doc::Atom(number(f64::from(i))), Doc::Atom(number(0.5))], ")");
    let mut text = String::new();
    let keys = group("[", (0..12).map(key).collect(), "]");
    group("Keys(", vec![field("few", key(0)), field("many", keys)], ")").print(0, 0, &mut text);
    assert!(text.starts_with("Keys(\n    few: (0.0, 0.5),\n    many: [\n        (0.0, 0.5),\n"), "{text}");
    assert!(text.ends_with("        (11.0, 0.5),\n    ],\n)"), "{text}");
    assert!(parse(&text, "keys", "Keys(…)").is_ok());
}

#[test]
fn suggestions_are_near_or_none() {
    let names = ["left_knee", "right_knee"];
    assert_eq!(did_you_mean("left_kne", names.into_iter()), "; did you mean 'left_knee'?");
    assert_eq!(did_you_mean("spine", names.into_iter()), "");
}

#[test]
fn brackets_and_values_are_counted_to_the_limit_and_not_beyond() {
    let deep = |depth: usize| format!("{}1{}", "(".repeat(depth), ")".repeat(depth));
    assert!(parse(&deep(64), "text", "(1)").is_ok());
    let error = parse(&deep(65), "text", "(1)").expect_err("too deep").to_string();
    assert!(error.contains("more than 64 deep"), "{error}");
    // The list is a value too.
    let many = |count: usize| format!("[{}]", "1,".repeat(count - 1));
    assert!(parse(&many(4_000_000), "text", "[1]").is_ok());
    let error = parse(&many(4_000_001), "text", "[1]").expect_err("too many").to_string();
    assert!(error.contains("4000000"), "{error}");
}
