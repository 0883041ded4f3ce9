//! The data that a page of this program holds.

/// How the data begin in a page.
const MARK: &str = "id=\"data\"";

/// The JSON text in a page of this program.
pub(super) fn data(page: &str) -> Option<&str> {
    let opens = page.match_indices("<script").find_map(|(at, _)| {
        let end = at + page[at..].find('>')?;
        let tag = &page[at..end];
        (tag.contains(MARK) && tag.contains("application/json")).then_some(end + 1)
    })?;
    let length = page[opens..].find("</script")?;
    Some(page[opens..opens + length].trim())
}

#[cfg(test)]
mod tests {
    use super::data;

    #[test]
    fn the_data_of_a_page_stand_in_one_script() {
        let page =
            "<script>x</script><script type=\"application/json\" id=\"data\">\n{\"a\": 1}\n</script><p>";
        assert_eq!(data(page), Some("{\"a\": 1}"));
        assert_eq!(data("<script id=\"data\">1</script>"), None);
        assert_eq!(data("<script type=\"application/json\" id=\"data\">{"), None);
    }
}
