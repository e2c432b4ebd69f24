//! The units that are known: one table.

use super::dimension::Dimension;
use super::exponent::Exponent;

/// A unit of the table.
pub(crate) struct Entry {
    /// Its symbol, and other spellings.
    pub symbols: &'static [&'static str],
    /// Powers of kg, m, s, A, K, mol, cd.
    pub powers: [i8; 7],
    /// The power of ten by which it differs from the product of base units.
    pub ten: i8,
    /// The power of sixty.
    pub sixty: i8,
    /// The power of the elementary charge in coulombs without its power of ten, 1602176634.
    pub charge: i8,
}

const fn entry(symbols: &'static [&'static str], powers: [i8; 7], ten: i8) -> Entry {
    Entry { symbols, powers, ten, sixty: 0, charge: 0 }
}

const MASS: [i8; 7] = [1, 0, 0, 0, 0, 0, 0];
const LENGTH: [i8; 7] = [0, 1, 0, 0, 0, 0, 0];
const TIME: [i8; 7] = [0, 0, 1, 0, 0, 0, 0];
const CURRENT: [i8; 7] = [0, 0, 0, 1, 0, 0, 0];
const TEMPERATURE: [i8; 7] = [0, 0, 0, 0, 1, 0, 0];
const FORCE: [i8; 7] = [1, 1, -2, 0, 0, 0, 0];
const ENERGY: [i8; 7] = [1, 2, -2, 0, 0, 0, 0];
const POWER: [i8; 7] = [1, 2, -3, 0, 0, 0, 0];
const PRESSURE: [i8; 7] = [1, -1, -2, 0, 0, 0, 0];
const FREQUENCY: [i8; 7] = [0, 0, -1, 0, 0, 0, 0];
const VOLTAGE: [i8; 7] = [1, 2, -3, -1, 0, 0, 0];
const NUMBER: [i8; 7] = [0; 7];

/// Every unit that is known.
pub(crate) const TABLE: &[Entry] = &[
    entry(&["kg"], MASS, 0),
    entry(&["g"], MASS, -3),
    entry(&["mg"], MASS, -6),
    entry(&["t"], MASS, 3),
    entry(&["m"], LENGTH, 0),
    entry(&["km"], LENGTH, 3),
    entry(&["cm"], LENGTH, -2),
    entry(&["mm"], LENGTH, -3),
    entry(&["um", "mum", "µm"], LENGTH, -6),
    entry(&["nm"], LENGTH, -9),
    entry(&["s"], TIME, 0),
    entry(&["ms"], TIME, -3),
    entry(&["us", "mus", "µs"], TIME, -6),
    entry(&["ns"], TIME, -9),
    Entry { symbols: &["min"], powers: TIME, ten: 0, sixty: 1, charge: 0 },
    Entry { symbols: &["h"], powers: TIME, ten: 0, sixty: 2, charge: 0 },
    entry(&["A"], CURRENT, 0),
    entry(&["mA"], CURRENT, -3),
    entry(&["K"], TEMPERATURE, 0),
    entry(&["mol"], [0, 0, 0, 0, 0, 1, 0], 0),
    entry(&["cd"], [0, 0, 0, 0, 0, 0, 1], 0),
    entry(&["N"], FORCE, 0),
    entry(&["mN"], FORCE, -3),
    entry(&["kN"], FORCE, 3),
    entry(&["dyn"], FORCE, -5),
    entry(&["J"], ENERGY, 0),
    entry(&["mJ"], ENERGY, -3),
    entry(&["kJ"], ENERGY, 3),
    entry(&["MJ"], ENERGY, 6),
    entry(&["erg"], ENERGY, -7),
    Entry { symbols: &["eV"], powers: ENERGY, ten: -28, sixty: 0, charge: 1 },
    Entry { symbols: &["keV"], powers: ENERGY, ten: -25, sixty: 0, charge: 1 },
    Entry { symbols: &["MeV"], powers: ENERGY, ten: -22, sixty: 0, charge: 1 },
    Entry { symbols: &["GeV"], powers: ENERGY, ten: -19, sixty: 0, charge: 1 },
    entry(&["W"], POWER, 0),
    entry(&["mW"], POWER, -3),
    entry(&["kW"], POWER, 3),
    entry(&["MW"], POWER, 6),
    entry(&["Pa"], PRESSURE, 0),
    entry(&["hPa"], PRESSURE, 2),
    entry(&["kPa"], PRESSURE, 3),
    entry(&["MPa"], PRESSURE, 6),
    entry(&["bar"], PRESSURE, 5),
    entry(&["Hz"], FREQUENCY, 0),
    entry(&["kHz"], FREQUENCY, 3),
    entry(&["MHz"], FREQUENCY, 6),
    entry(&["C"], [0, 0, 1, 1, 0, 0, 0], 0),
    entry(&["V"], VOLTAGE, 0),
    entry(&["mV"], VOLTAGE, -3),
    entry(&["kV"], VOLTAGE, 3),
    entry(&["ohm", "Omega", "Ω"], [1, 2, -3, -2, 0, 0, 0], 0),
    entry(&["F"], [-1, -2, 4, 2, 0, 0, 0], 0),
    entry(&["H"], [1, 2, -2, -2, 0, 0, 0], 0),
    entry(&["T"], [1, 0, -2, -1, 0, 0, 0], 0),
    entry(&["Wb"], [1, 2, -2, -1, 0, 0, 0], 0),
    entry(&["L", "l"], [0, 3, 0, 0, 0, 0, 0], -3),
    entry(&["rad"], NUMBER, 0),
    entry(&["sr"], NUMBER, 0),
];

/// The prime factors of which the units differ: 2, 3, 5, and 801088317 of the elementary charge, which no other unit has.
pub(crate) type Scale = [Exponent; 4];

impl Entry {
    pub(crate) fn dimension(&self) -> Dimension {
        Dimension(self.powers.map(|power| Exponent::whole(i64::from(power))))
    }

    /// The exponents of the factor by which it differs from the product of base units. 10 = 2·5, 60 = 2²·3·5,
    /// 1602176634 = 2·801088317.
    pub(crate) fn scale(&self) -> Scale {
        let [ten, sixty, charge] = [self.ten, self.sixty, self.charge].map(i64::from);
        [ten + 2 * sixty + charge, sixty, ten + sixty, charge].map(Exponent::whole)
    }
}

/// The symbols of all units that are known, in the order of the table.
pub fn known() -> impl Iterator<Item = &'static str> {
    TABLE.iter().filter_map(|entry| entry.symbols.first().copied())
}
