//! Lines and areas cut off at the edges of the unit square.

/// The part of a line in the unit square, in pieces.
pub(super) fn inside(points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    for pair in points.windows(2) {
        let ((x, y), (dx, dy)) = (pair[0], (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1));
        // From where to where on the way from one point to the next, for each edge.
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (p, q) in [(-dx, x), (dx, 1.0 - x), (-dy, y), (dy, 1.0 - y)] {
            if p == 0.0 {
                if q < 0.0 {
                    to = -1.0;
                }
            } else if p < 0.0 {
                from = from.max(q / p);
            } else {
                to = to.min(q / p);
            }
        }
        if from > to {
            continue;
        }
        let at = |t: f64| (x + t * dx, y + t * dy);
        match pieces.last_mut() {
            Some(piece) if from == 0.0 && piece.last() == Some(&pair[0]) => {}
            _ => pieces.push(vec![at(from)]),
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(if to == 1.0 { pair[1] } else { at(to) });
        }
    }
    pieces
}

/// How far a point lies inside of an edge.
type Depth = fn(&(f64, f64)) -> f64;

/// The part of an area in the unit square: cut along one edge after the other.
pub(super) fn area_inside(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let edges: [Depth; 4] = [|p| p.0, |p| 1.0 - p.0, |p| p.1, |p| 1.0 - p.1];
    let mut area = points.to_vec();
    for depth in edges {
        let mut kept = Vec::new();
        for (place, b) in area.iter().enumerate() {
            let a = &area[if place == 0 { area.len() - 1 } else { place - 1 }];
            let (from, to) = (depth(a), depth(b));
            if (from < 0.0) != (to < 0.0) {
                let t = from / (from - to);
                kept.push((a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)));
            }
            if to >= 0.0 {
                kept.push(*b);
            }
        }
        area = kept;
    }
    area
}
