//! Which column of a table of chains holds what.

use crate::claim::diagnostic::nearest;
use crate::cli::Exit;
use crate::scene::quantity::{Input, Quantity};
use crate::table::foreign::{Fields, Foreign, Role};
use std::io::BufRead;

/// The columns, in the order in which they are printed, and in which a table without a heading has them.
pub(super) const NAMES: [&str; 4] = ["m1", "m2", "e", "n"];
const ROLES: [Role; 4] = [Role::First, Role::Last, Role::E, Role::N];

/// The places of m1, m2, e and n.
pub(super) struct Columns([Option<usize>; 4]);

impl Columns {
    /// Those of a table, for all that is wanted. Doubled ones have been refused when it was opened.
    ///
    /// # Errors
    /// A column that is unknown, or that is needed and missing.
    pub(super) fn of<R: BufRead>(table: &Foreign<R>, want: &[Quantity]) -> Result<Columns, Exit> {
        for (place, name) in table.names.iter().enumerate() {
            let role = table.roles.iter().find(|role| role.0 == place).map(|role| role.1);
            // R and pandas write a column without a name, the numbers of the rows.
            if name.is_empty() || role.is_some_and(|role| ROLES.contains(&role)) {
                continue;
            }
            let help = match nearest(name, NAMES) {
                Some(near) => format!("did you mean {near}?"),
                None => "leave it out".to_owned(),
            };
            return Err(Exit::usage(format!("error: column {name:?}: the columns are m1, m2, e and n; {help}")));
        }
        let places = ROLES.map(|role| table.column(role));
        for (name, place) in NAMES.iter().zip(places) {
            let needed = match *name {
                "e" => want.iter().find(|quantity| quantity.needs().inputs.contains(&Input::Restitution)),
                "n" => want.iter().find(|quantity| quantity.needs().inputs.contains(&Input::Inserted)),
                _ => want.first(),
            };
            if let (None, Some(quantity)) = (place, needed) {
                let message = format!("error: there is no column {name}, which {} needs; add it", quantity.name());
                return Err(Exit::usage(message));
            }
        }
        Ok(Columns(places))
    }

    /// The fields m1, m2, e and n of a row; those without a column are empty.
    pub(super) fn fields<'a>(&self, row: &'a Fields) -> [&'a str; 4] {
        self.0.map(|place| place.and_then(|place| row.fields.get(place)).map_or("", String::as_str))
    }
}
