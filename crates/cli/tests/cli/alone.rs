//! Whatever the program writes stands alone: opened anywhere, it asks nothing of the network.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Names of languages, which look like addresses and are never fetched.
const NAMES: [&str; 2] = ["http://www.w3.org/2000/svg", "http://www.w3.org/1999/xhtml"];

/// What a script or a style would fetch with.
const FETCHING: [&str; 8] = [
    "@import",
    "EventSource(",
    "WebSocket(",
    "XMLHttpRequest",
    "fetch(",
    "import(",
    "importScripts",
    "sendBeacon",
];

/// What each attribute and function names, outside of the file itself.
fn leads_out(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for (before, ends) in
        [("src=\"", '"'), ("src='", '\''), ("href=\"", '"'), ("href='", '\''), ("url(", ')')]
    {
        let values = text.split(before).skip(1).filter_map(|rest| rest.split(ends).next());
        let values = values.map(|value| value.trim_matches(['"', '\'']));
        found.extend(values.filter(|value| !value.starts_with("data:") && !value.starts_with('#')));
    }
    found
}

/// Why a file does not stand alone.
fn fault(name: &str, bytes: &[u8]) -> Option<String> {
    // Of a `.glb` the first chunk is text; in numbers anything may stand.
    let bytes = match bytes.get(12..16).and_then(|length| length.try_into().ok()).map(u32::from_le_bytes) {
        Some(length) if bytes.starts_with(b"glTF") => &bytes[20..20 + length as usize],
        _ => bytes,
    };
    let mut text = String::from_utf8_lossy(bytes).into_owned();
    for name in NAMES {
        text = text.replace(name, "");
    }
    if let Some(at) = text.find("://") {
        let around: String = text[..at].chars().rev().take(20).collect();
        return Some(format!(
            "an address: …{}://{:.40}",
            around.chars().rev().collect::<String>(),
            &text[at + 3..]
        ));
    }
    match name.rsplit('.').next() {
        Some("html" | "svg") => {
            if let Some(word) = FETCHING.iter().find(|word| text.contains(*word)) {
                return Some(format!("it has {word}"));
            }
            // Scripts put addresses together that are no markup: of them, the words above are looked for.
            let markup: String =
                text.split("<script").map(|part| part.rsplit("</script>").next().unwrap_or("")).collect();
            if let Some(out) = leads_out(&markup).first() {
                return Some(format!("it leads to {out}"));
            }
            let policy = text
                .split("Content-Security-Policy\" content=\"")
                .nth(1)
                .and_then(|rest| rest.split('"').next());
            match policy {
                None if Path::new(name).extension().is_some_and(|ext| ext == "html") => {
                    Some("it has no policy".to_owned())
                }
                Some(policy)
                    if !policy.starts_with("default-src 'none'") || policy.contains("connect-src") =>
                {
                    Some(format!("its policy is {policy}"))
                }
                _ => None,
            }
        }
        // Buffers and pictures are in the file.
        Some("glb") => text.contains("\"uri\"").then(|| "it names a file".to_owned()),
        // Between two of these stands the path of another file.
        Some("usda") => text.contains('@').then(|| "it refers to a file".to_owned()),
        _ => None,
    }
}

#[test]
fn what_is_written_asks_nothing_of_the_network() {
    let folder = tempfile::tempdir().expect("a folder");
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let pendulum = fs::read_to_string(fixtures.join("scenes/pendulum.ron")).expect("a scene");
    fs::write(folder.path().join("short.ron"), pendulum.replace("duration: 10.0", "duration: 0.1"))
        .expect("written");
    let commands = [
        "walk --steps 2 --rate 30 -o walk.html -o walk.csv -o walk.bvh -o walk.glb -o walk.usda -o walk.svg --report walk.json",
        "run F/scenes/pendulum.ron -o run.html -o run.svg -o run.sto --report run.json",
        "report short.ron --error 1e-4 -o report.html -o report.svg",
        "inverse F/subject/subject.osim F/subject/walk.mot --ground --soles F/subject/soles.ron -o moments.html -o moments.sto",
        "profile minimum-jerk --from 0 --to 1 --duration 1 -o curve.html -o curve.svg -o curve.ron",
        "convert F/clips/walk.c3d markers.trc",
        "figure human -o human.ron",
        "man -o man",
    ];
    for command in commands {
        let words = command.split(' ').map(|word| word.replace("F/", &format!("{}/", fixtures.display())));
        let output =
            Command::new(env!("CARGO_BIN_EXE_solaris")).current_dir(folder.path()).args(words).output();
        let output = output.expect("the program starts");
        assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
    }
    let mut seen = 0;
    let mut folders = vec![folder.path().to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            if let Some(fault) = fault(&name, &fs::read(&path).expect("readable")) {
                panic!("{name}: {fault}");
            }
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen} files");
}

#[test]
fn what_does_not_stand_alone_is_found() {
    let page = |inside: &str| {
        format!(
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'\">{inside}<script>let a;</script>"
        )
    };
    assert_eq!(fault("a.html", page("<img src=\"data:image/png,x\"><a href=\"#b\">").as_bytes()), None);
    for inside in [
        "<img src=\"https://example.org/a.png\">",
        "<img src='//example.org/a.png'>",
        "<link href=\"style.css\">",
        "<style>@import 'x';</style>",
        "<style>a { background: url(b.png) }</style>",
        "<script>fetch('x')</script>",
    ] {
        assert!(fault("a.html", page(inside).as_bytes()).is_some(), "{inside}");
    }
    assert!(fault("a.html", b"<p>without a policy</p>").is_some());
    assert!(fault("a.glb", b"{\"buffers\":[{\"uri\":\"a.bin\"}]}").is_some());
    assert!(fault("a.usda", b"references = @other.usda@").is_some());
    assert!(fault("a.ron", b"// https://example.org").is_some());
}
