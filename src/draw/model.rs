//! Meshes as Wavefront OBJ and as binary glTF.

use std::fmt::Write as _;

use crate::exact::Rational;
use crate::mesh::Mesh;

/// The mesh as Wavefront OBJ. Coordinates are the decimals nearest to the exact
/// ones; equal vertices are one vertex.
///
/// ```
/// use casteljau::{Mesh, Piece, Rational, Triangle, TriangularPatch, draw::obj};
/// let points = [[0, 0, 0], [0, 1, 0], [1, 0, 2]].map(|point| point.map(Rational::from).to_vec()).to_vec();
/// let patch = TriangularPatch::from_points(points, Triangle::standard())?;
/// let text = obj(&Mesh::of(&Piece::Triangle(patch), false, 0)?);
/// assert!(text.ends_with("v 0 0 0\nv 0 1 0\nv 1 0 2\nf 1 3 2\n"));
/// # Ok::<(), casteljau::Error>(())
/// ```
#[must_use]
pub fn obj(mesh: &Mesh) -> String {
    let mut text = String::from("# made by casteljau; coordinates ≈ the nearest decimals\n");
    for vertex in mesh.vertices() {
        let [x, y, z] = vertex.each_ref().map(Rational::approximate);
        // Writing to a string does not fail.
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for [a, b, c] in mesh.triangles() {
        let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
    }
    text
}

/// The vertices as single floats, and normals: sums of those of the triangles
/// around each, weighted by area.
fn floats(mesh: &Mesh) -> (Vec<[f32; 3]>, Vec<[f32; 3]>) {
    let places: Vec<[f64; 3]> = mesh.vertices().iter().map(|vertex| vertex.each_ref().map(Rational::approximate)).collect();
    let mut normals = vec![[0.0f64; 3]; places.len()];
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|index| places[index as usize]);
        let normal = cross(minus(b, a), minus(c, a));
        for index in triangle {
            for (sum, part) in normals[*index as usize].iter_mut().zip(normal) {
                *sum += part;
            }
        }
    }
    let unit = |normal: [f64; 3]| {
        let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length > 0.0 { normal.map(|x| (x / length) as f32) } else { [0.0, 0.0, 1.0] }
    };
    (places.iter().map(|place| place.map(|x| x as f32)).collect(), normals.into_iter().map(unit).collect())
}

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The mesh as a binary glTF 2.0 document, with normals. Positions are the
/// single floats nearest to the exact coordinates.
#[must_use]
pub fn glb(mesh: &Mesh) -> Vec<u8> {
    let (places, normals) = floats(mesh);
    let bound = |pick: fn(f32, f32) -> f32, start: f32| {
        let axis = |axis: usize| places.iter().map(|place| place[axis]).fold(start, pick);
        format!("[{},{},{}]", axis(0), axis(1), axis(2))
    };
    let (low, high) = (bound(f32::min, f32::INFINITY), bound(f32::max, f32::NEG_INFINITY));
    let (size, indices) = (places.len() * 12, mesh.triangles().len() * 12);
    // Numbers of the format: 34962 and 34963 are targets of buffers, 5126 and 5125 types of numbers.
    let mut json = format!(
        "{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"casteljau\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{{\"mesh\":0}}],\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0,\"NORMAL\":1}},\"indices\":2,\"material\":0}}]}}],\
         \"materials\":[{{\"doubleSided\":true,\"pbrMetallicRoughness\":{{\"baseColorFactor\":[0.36,0.55,0.78,1],\"metallicFactor\":0,\"roughnessFactor\":0.6}}}}],\
         \"buffers\":[{{\"byteLength\":{}}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteOffset\":0,\"byteLength\":{size},\"target\":34962}},\
         {{\"buffer\":0,\"byteOffset\":{size},\"byteLength\":{size},\"target\":34962}},\
         {{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{indices},\"target\":34963}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":{},\"type\":\"VEC3\",\"min\":{low},\"max\":{high}}},\
         {{\"bufferView\":1,\"componentType\":5126,\"count\":{},\"type\":\"VEC3\"}},\
         {{\"bufferView\":2,\"componentType\":5125,\"count\":{},\"type\":\"SCALAR\"}}]}}",
        2 * size + indices,
        2 * size,
        places.len(),
        places.len(),
        mesh.triangles().len() * 3
    );
    while !json.len().is_multiple_of(4) {
        json.push(' ');
    }
    let mut bytes = Vec::with_capacity(28 + json.len() + 2 * size + indices);
    let word = |bytes: &mut Vec<u8>, value: usize| bytes.extend_from_slice(&(value as u32).to_le_bytes());
    bytes.extend_from_slice(b"glTF");
    word(&mut bytes, 2);
    word(&mut bytes, 28 + json.len() + 2 * size + indices);
    word(&mut bytes, json.len());
    bytes.extend_from_slice(b"JSON");
    bytes.extend_from_slice(json.as_bytes());
    word(&mut bytes, 2 * size + indices);
    bytes.extend_from_slice(b"BIN\0");
    for float in places.iter().chain(&normals).flatten() {
        bytes.extend_from_slice(&float.to_le_bytes());
    }
    for index in mesh.triangles().iter().flatten() {
        bytes.extend_from_slice(&index.to_le_bytes());
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::affine::Rectangle;
    use crate::piece::Piece;
    use crate::rectangular::RectangularPatch;

    #[test]
    fn the_parts_of_a_binary_document_have_the_lengths_it_says() {
        let rows = [[0, 1], [2, 7]].map(|row| row.map(|z| vec![Rational::from(z)]).to_vec()).to_vec();
        let patch = RectangularPatch::from_rows(rows, Rectangle::unit()).expect("a patch");
        let bytes = glb(&Mesh::of(&Piece::Rectangle(patch), false, 2).expect("a mesh"));
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]) as usize;
        assert_eq!((word(4), word(8)), (2, bytes.len()));
        let json = word(12);
        assert_eq!(&bytes[16..20], b"JSON");
        assert_eq!(word(20 + json), bytes.len() - 28 - json);
        let text = std::str::from_utf8(&bytes[20..20 + json]).expect("text");
        assert!(
            text.contains("\"min\":[0,0,0],\"max\":[1,1,7]") && text.contains("\"count\":25,") && text.contains("\"count\":96,"),
            "{text}"
        );
    }
}
