//! Polygons into triangles.

use glam::Vec3;

/// Most corners of a polygon that is searched for ears: the search takes quadratic time and more.
const MAX_EAR_CORNERS: usize = 256;

/// Triangles of a simple polygon, by its corners' indices (`corners` relative to one of them): a fan where it is convex, by ear clipping where it is not
/// (ElGindy, Everett and Toussaint 1993). A polygon that is no simple one, or very large, gives a fan.
pub fn triangulate(corners: &[Vec3]) -> Vec<[usize; 3]> {
    let n = corners.len();
    let normal = newell_normal(corners);
    let turns_left =
        |a: usize, b: usize, c: usize| (corners[b] - corners[a]).cross(corners[c] - corners[b]).dot(normal) >= 0.0;
    let is_convex = (0..n).all(|i| turns_left(i, (i + 1) % n, (i + 2) % n));
    let fan = |ring: &[usize]| (1..ring.len() - 1).map(|i| [ring[0], ring[i], ring[i + 1]]).collect::<Vec<_>>();
    let mut ring: Vec<usize> = (0..n).collect();
    if n <= 3 || is_convex || n > MAX_EAR_CORNERS {
        return fan(&ring);
    }
    let mut triangles = Vec::with_capacity(n - 2);
    while ring.len() > 3 {
        let m = ring.len();
        let ear = (0..m).find(|&i| {
            let [a, b, c] = [ring[(i + m - 1) % m], ring[i], ring[(i + 1) % m]];
            let others = ring.iter().filter(|&&p| p != a && p != b && p != c);
            turns_left(a, b, c) && others.into_iter().all(|&p| !contains(corners, [a, b, c], p, normal))
        });
        let Some(i) = ear else { break };
        triangles.push([ring[(i + m - 1) % m], ring[i], ring[(i + 1) % m]]);
        ring.remove(i);
    }
    triangles.extend(fan(&ring));
    triangles
}

/// The polygon's area vector; its direction is the front's normal.
fn newell_normal(corners: &[Vec3]) -> Vec3 {
    let following = corners.iter().cycle().skip(1);
    corners.iter().zip(following).map(|(&a, &b)| a.cross(b)).sum()
}

fn contains(corners: &[Vec3], triangle: [usize; 3], point: usize, normal: Vec3) -> bool {
    let p = corners[point];
    (0..3).all(|i| {
        let (a, b) = (corners[triangle[i]], corners[triangle[(i + 1) % 3]]);
        (b - a).cross(p - a).dot(normal) >= 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(corners: &[Vec3], triangles: &[[usize; 3]]) -> f32 {
        let of = |t: &[usize; 3]| (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).z * 0.5;
        assert!(triangles.iter().all(|t| of(t) >= 0.0), "no triangle may be turned over: {triangles:?}");
        triangles.iter().map(of).sum()
    }

    fn polygon(points: &[(f32, f32)]) -> Vec<Vec3> {
        points.iter().map(|&(x, y)| Vec3::new(x, y, 0.5)).collect()
    }

    #[test]
    fn convex_polygons_become_fans() {
        let square = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        assert_eq!(triangulate(&square), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn concave_polygons_keep_their_area() {
        // An L, and an arrow whose fan from the first corner would leave it.
        let l = polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]);
        assert_eq!(area(&l, &triangulate(&l)), 3.0);
        let arrow = polygon(&[(2.0, 0.0), (0.0, 3.0), (-2.0, 0.0), (0.0, 1.0)]);
        let triangles = triangulate(&arrow);
        assert_eq!((triangles.len(), area(&arrow, &triangles)), (2, 4.0));
    }

    #[test]
    fn a_polygon_that_crosses_itself_still_gives_all_its_triangles() {
        let star = polygon(&[(0.0, 1.0), (0.6, -0.8), (-0.95, 0.3), (0.95, 0.3), (-0.6, -0.8)]);
        assert_eq!(triangulate(&star).len(), 3);
    }
}
