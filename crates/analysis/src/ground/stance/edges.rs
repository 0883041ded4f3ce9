//! Spans in which a signal is below zero, short gaps and short spans left out.

/// Spans of time (s) in which `decides` is less than zero, put between frames by straight lines. Gaps shorter than
/// `shortest` (s) are closed, then shorter spans are dropped, unless an end of the motion cuts them off.
pub(super) fn standing(time: &[f64], decides: &[f64], shortest: f64) -> Vec<(f64, f64)> {
    let down = |i: usize| decides[i] < 0.0;
    let edge = |i: usize| {
        let (a, b) = (decides[i], decides[i + 1]);
        let s = if (b - a).is_finite() { a / (a - b) } else { 0.5 };
        time[i] + s * (time[i + 1] - time[i])
    };
    let mut spans: Vec<(f64, f64)> = Vec::new();
    let mut start = None;
    for i in 0..time.len() {
        if down(i) && start.is_none() {
            start = Some(if i == 0 { time[0] } else { edge(i - 1) });
        }
        if down(i) && (i + 1 == time.len() || !down(i + 1)) {
            let end = if i + 1 == time.len() { time[i] } else { edge(i) };
            if let Some(start) = start.take() {
                match spans.last_mut() {
                    Some(last) if start - last.1 < shortest => last.1 = end,
                    _ => spans.push((start, end)),
                }
            }
        }
    }
    let (Some(&first), Some(&last)) = (time.first(), time.last()) else { return spans };
    spans.retain(|&(start, end)| end - start >= shortest || start <= first || end >= last);
    spans
}

/// Where a signal crosses zero next to an edge that is about known: from the frame `near` on, outwards (`ahead`: to later
/// frames) while it is less than zero, or else inwards until it is, but not beyond the frame `middle`.
pub(super) fn crossing(
    time: &[f64],
    middle: usize,
    near: usize,
    ahead: bool,
    decides: impl Fn(usize) -> f64,
) -> f64 {
    let out = |row: usize| if ahead { (row + 1 < time.len()).then_some(row + 1) } else { row.checked_sub(1) };
    let mut row = near;
    // Inwards, until it is down.
    while decides(row) >= 0.0 && row != middle {
        row = if ahead { row - 1 } else { row + 1 };
    }
    // Outwards, as long as it is.
    loop {
        let Some(next) = out(row) else { return time[row] };
        let (a, b) = (decides(row), decides(next));
        if b >= 0.0 || a >= 0.0 {
            let s = if (b - a).is_finite() && a < 0.0 { a / (a - b) } else { 0.5 };
            return time[row] + s * (time[next] - time[row]);
        }
        row = next;
    }
}

#[cfg(test)]
mod tests {
    use super::{crossing, standing};

    #[test]
    fn edges_lie_where_the_line_crosses_zero() {
        let time = [0.0, 1.0, 2.0, 3.0];
        assert_eq!(standing(&time, &[3.0, -1.0, -1.0, 1.0], 0.1), [(0.75, 2.5)]);
    }

    #[test]
    fn short_gaps_are_closed_and_short_stances_dropped_but_at_the_ends() {
        let time: Vec<f64> = (0..10).map(f64::from).collect();
        let decides = [-1.0, 1.0, 1.0, 1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0];
        // Half a second at either end; 3.5 to 4.5 and 5.5 to 6.5 with a gap of one second between.
        assert_eq!(standing(&time, &decides, 0.1), [(0.0, 0.5), (3.5, 4.5), (5.5, 6.5), (8.5, 9.0)]);
        assert_eq!(standing(&time, &decides, 1.5), [(0.0, 0.5), (3.5, 6.5), (8.5, 9.0)]);
        assert_eq!(standing(&time, &decides, 2.5), [(0.0, 0.5), (3.5, 9.0)]);
    }

    #[test]
    fn what_never_comes_down_never_stands() {
        assert_eq!(standing(&[0.0, 1.0], &[f64::INFINITY; 2], 0.1), []);
        assert_eq!(standing(&[0.5], &[-1.0], 0.1), [(0.5, 0.5)]);
    }

    #[test]
    fn an_edge_is_sought_inwards_until_it_is_down_and_then_outwards() {
        let time = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0];
        let decides = |row: usize| [6.0, -2.0, -1.0, -5.0, -2.0, 8.0][row];
        // From 6 to −2 the line is at zero after three quarters of a second, from −2 to 8 after a fifth.
        for near in 0..=3 {
            assert_eq!(crossing(&time, 3, near, false, decides).to_bits(), 0.75_f64.to_bits(), "{near}");
        }
        for near in 2..=5 {
            assert_eq!(crossing(&time, 2, near, true, decides).to_bits(), 4.2_f64.to_bits(), "{near}");
        }
        // What is down at the end of the motion has its edge there.
        assert_eq!(crossing(&time[..5], 2, 3, true, decides).to_bits(), 4.0_f64.to_bits());
        assert_eq!(crossing(&time, 3, 3, false, |_| -1.0).to_bits(), 0.0_f64.to_bits());
    }
}
