//! Names of components as paths: `/bodyset/pelvis`, `../pelvis_offset`.

use crate::xml::Node;

/// The absolute path of a component below the model: the names of the components that it stands in.
///
/// Lists (`objects`, `frames`, `components`) have no part in it; a set or a joint without a name has that of its element in
/// small letters.
pub(super) fn path_of(node: Node, model: Node) -> String {
    let above = node.ancestors().take_while(|ancestor| *ancestor != model);
    let mut names: Vec<String> = above
        .filter_map(|ancestor| {
            let tag = ancestor.tag_name().name();
            let name = ancestor.attribute("name").map(str::trim).filter(|name| !name.is_empty());
            let unnamed = || (tag.ends_with("Set") || tag.ends_with("Joint")).then(|| tag.to_lowercase());
            name.map(ToOwned::to_owned).or_else(unnamed)
        })
        .collect();
    names.reverse();
    joined(&names)
}

/// The absolute path that `path` is when the component at `from` says it.
pub(super) fn resolved(from: &str, path: &str) -> String {
    let start = if path.starts_with('/') { "" } else { from };
    let mut names: Vec<&str> = Vec::new();
    for name in start.split('/').chain(path.split('/')) {
        match name {
            "" | "." => {}
            ".." => {
                names.pop();
            }
            name => names.push(name),
        }
    }
    joined(&names)
}

fn joined<S: AsRef<str>>(names: &[S]) -> String {
    names.iter().fold(String::new(), |path, name| path + "/" + name.as_ref())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_those_of_a_file_system() {
        assert_eq!(resolved("/jointset/knee", "/bodyset/tibia"), "/bodyset/tibia");
        assert_eq!(resolved("/jointset/knee", "tibia_offset"), "/jointset/knee/tibia_offset");
        assert_eq!(resolved("/jointset/knee/tibia_offset", "../../../bodyset/tibia"), "/bodyset/tibia");
        assert_eq!(resolved("/a", "../../../b/./c"), "/b/c");
    }
}
