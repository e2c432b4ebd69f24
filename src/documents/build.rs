//! Makes the font of the pictures smaller: DejaVu Sans without its programs for coarse screens, its names and its tables for
//! setting text. What is left gives the same outlines, and is two thirds as long when compressed.
//!
//! The names of tables and fields are those of the OpenType specification: <https://learn.microsoft.com/typography/opentype/spec>.

use std::path::PathBuf;
use std::{env, fs};

/// The tables that outlines, widths and the numbers of letters need, by name as in the file's directory; `glyf` and `loca`
/// are written anew.
const KEPT: [&[u8; 4]; 7] = [b"cmap", b"glyf", b"head", b"hhea", b"hmtx", b"loca", b"maxp"];
/// Bytes of the file's header and of an entry of its directory.
const HEADER: usize = 12;
const ENTRY: usize = 16;
/// Where `glyf` has a letter's number of contours, and where the ends of the contours begin.
const CONTOURS: usize = 10;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo:rerun-if-changed=build.rs");
    let font = outlines(dejavu::sans::regular()).ok_or("the font DejaVu Sans is not as expected")?;
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?);
    fs::write(out.join("outlines.ttf"), font)?;
    Ok(())
}

/// The font without what outlines do not need; `None` where it is not a font of this kind.
fn outlines(font: &[u8]) -> Option<Vec<u8>> {
    let (glyf, loca) = letters(table(font, b"glyf")?, table(font, b"loca")?)?;
    let tables: Vec<(&[u8; 4], &[u8])> = KEPT
        .into_iter()
        .map(|name| match name {
            b"glyf" => Some((name, glyf.as_slice())),
            b"loca" => Some((name, loca.as_slice())),
            _ => Some((name, table(font, name)?)),
        })
        .collect::<Option<_>>()?;
    let mut out = font.get(..4)?.to_vec();
    // The number of tables; the three numbers after it speed up a search that nobody makes.
    out.extend(u16::try_from(tables.len()).ok()?.to_be_bytes());
    out.extend([0; 6]);
    let mut place = HEADER + ENTRY * tables.len();
    for (name, bytes) in &tables {
        out.extend(*name);
        // The checksum.
        out.extend([0; 4]);
        out.extend(u32::try_from(place).ok()?.to_be_bytes());
        out.extend(u32::try_from(bytes.len()).ok()?.to_be_bytes());
        place += bytes.len().next_multiple_of(4);
    }
    for (_, bytes) in &tables {
        out.extend(*bytes);
        out.resize(out.len().next_multiple_of(4), 0);
    }
    Some(out)
}

/// A table of a font.
fn table<'a>(font: &'a [u8], name: &[u8; 4]) -> Option<&'a [u8]> {
    let count = usize::from(short(font, 4)?);
    let place = (0..count).map(|i| HEADER + ENTRY * i).find(|&at| font.get(at..at + 4) == Some(name))?;
    let (start, length) = (long(font, place + 8)?, long(font, place + 12)?);
    font.get(start..start + length)
}

/// The outlines without their programs, and where each begins and ends, in four bytes (`indexToLocFormat` is 1).
fn letters(glyf: &[u8], loca: &[u8]) -> Option<(Vec<u8>, Vec<u8>)> {
    let places: Vec<usize> = (0..loca.len() / 4).map(|i| long(loca, 4 * i)).collect::<Option<_>>()?;
    let (mut out, mut starts) = (Vec::new(), vec![0; 4]);
    for ends in places.windows(2) {
        let letter = glyf.get(ends[0]..ends[1])?;
        // The number of contours is negative in a letter that consists of others; the program stands at its end, and is short.
        match short(letter, 0) {
            Some(contours) if contours <= i16::MAX as u16 => {
                let program = CONTOURS + 2 * usize::from(contours);
                let points = program + 2 + usize::from(short(letter, program)?);
                out.extend(letter.get(..program)?);
                out.extend([0, 0]);
                out.extend(letter.get(points..)?);
            }
            _ => out.extend(letter),
        }
        starts.extend(u32::try_from(out.len()).ok()?.to_be_bytes());
    }
    Some((out, starts))
}

fn short(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_be_bytes(bytes.get(at..at + 2)?.try_into().ok()?))
}

fn long(bytes: &[u8], at: usize) -> Option<usize> {
    usize::try_from(u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?)).ok()
}
