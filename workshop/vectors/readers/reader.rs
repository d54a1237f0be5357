// Reads a pack of vectors: rustc -O reader.rs && ./reader near.json
use std::collections::BTreeMap;

// enough of JSON for a pack
#[derive(Default)]
struct Value {
    text: String, // of strings and numbers
    list: Vec<Value>,
    fields: BTreeMap<String, Value>,
}

struct Parser<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Parser<'_> {
    fn space(&mut self) -> u8 {
        while matches!(self.bytes[self.at], b' ' | b'\n') {
            self.at += 1;
        }
        self.bytes[self.at]
    }

    fn quoted(&mut self) -> String {
        let begin = self.at + 1;
        self.at = begin;
        while self.bytes[self.at] != b'"' {
            self.at += if self.bytes[self.at] == b'\\' { 2 } else { 1 };
        }
        self.at += 1;
        String::from_utf8_lossy(&self.bytes[begin..self.at - 1]).into_owned()
    }

    fn value(&mut self) -> Value {
        let mut found = Value::default();
        match self.space() {
            b'"' => found.text = self.quoted(),
            opening @ (b'[' | b'{') => {
                self.at += 1;
                loop {
                    match self.space() {
                        b']' | b'}' => break,
                        b',' => self.at += 1,
                        _ if opening == b'[' => found.list.push(self.value()),
                        _ => {
                            let name = self.quoted();
                            self.space();
                            self.at += 1; // the colon
                            found.fields.insert(name, self.value());
                        }
                    }
                }
                self.at += 1;
            }
            _ => {
                let begin = self.at;
                while self.at < self.bytes.len() && !b",]} \n".contains(&self.bytes[self.at]) {
                    self.at += 1;
                }
                found.text = String::from_utf8_lossy(&self.bytes[begin..self.at]).into_owned();
            }
        }
        found
    }
}

// a C99 hexadecimal double such as -0x1.8p+3
fn number(text: &str) -> f64 {
    let (sign, rest) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (digits, exponent) = rest[2..].split_once('p').unwrap();
    let (lead, tail) = digits.split_once('.').unwrap_or((digits, ""));
    let (mut value, mut power) = (lead.parse::<f64>().unwrap(), 1.0);
    for digit in tail.chars() {
        power /= 16.0;
        value += f64::from(digit.to_digit(16).unwrap()) * power;
    }
    let e: i32 = exponent.parse().unwrap();
    sign * value * 2f64.powi(e / 2) * 2f64.powi(e - e / 2)
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0u32, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |c, _| if c & 1 == 1 { (c >> 1) ^ 0xedb8_8320 } else { c >> 1 })
    })
}

// the homogeneous point at t, in doubles
fn de_boor(degree: usize, knots: &[f64], rows: &[Vec<f64>], t: f64) -> Vec<f64> {
    let j = (degree..knots.len() - degree - 1).rev().find(|&k| knots[k] < knots[k + 1] && knots[k] <= t).unwrap_or(degree);
    let mut d: Vec<Vec<f64>> = rows[j - degree..=j].to_vec();
    for r in 1..=degree {
        for i in (r..=degree).rev() {
            let (a, b) = (knots[j - degree + i], knots[j + 1 + i - r]);
            let s = (t - a) / (b - a);
            d[i] = (0..d[i].len()).map(|k| (1.0 - s) * d[i - 1][k] + s * d[i][k]).collect();
        }
    }
    d.pop().unwrap()
}

fn numbers(list: &Value) -> Vec<f64> {
    list.list.iter().map(|each| number(&each.text)).collect()
}

// the control points times their weights, and the weights
fn homogeneous(given: &Value) -> Vec<Vec<f64>> {
    let weights = numbers(&given.fields["weights"]);
    let with_weight = |(p, w): (&Value, &f64)| numbers(p).iter().map(|x| x * w).chain([*w]).collect();
    given.fields["points"].list.iter().zip(&weights).map(with_weight).collect()
}

fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).expect("name a file")).expect("a readable file");
    let names = ["cases", "damaged", "none", "these", "all", "undefined", "inexact", "meetings", "apart"];
    let mut counts: BTreeMap<String, u64> = names.iter().map(|name| (name.to_string(), 0)).collect();
    for line in text.lines() {
        let Some(rest) = line.strip_prefix("{\"digest\":\"") else { continue };
        let body = &rest[8 + "\",\"case\":".len()..rest.rfind('}').unwrap()];
        let data = Parser { bytes: body.as_bytes(), at: 0 }.value().fields;
        *counts.get_mut("cases").unwrap() += 1;
        *counts.get_mut("damaged").unwrap() += u64::from(format!("{:08x}", crc32(body.as_bytes())) != rest[..8]);
        for answer in data["answers"].fields.values() {
            *counts.get_mut(&answer.fields["answer"].text).unwrap() += 1;
        }
        let (rows, partner) = (homogeneous(&data["doubles"]), homogeneous(&data["partner"].fields["doubles"]));
        let (degree, knots) = (data["degree"].text.parse().unwrap(), numbers(&data["doubles"].fields["knots"]));
        let point = de_boor(degree, &knots, &rows, number(&data["parameter"].fields["double"].text));
        let (w, truth) = (point[point.len() - 1], &data["answers"].fields["value"].fields["items"].list[0].fields);
        let axes = ["x", "y", "z"];
        let right = (0..point.len() - 1).all(|k| point[k] / w == number(&truth[axes[k]].list[1].text));
        *counts.get_mut("inexact").unwrap() += u64::from(!right);
        let size = rows.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        // the points that a curve and its partner have in common; apart: that differ by more than 2^-40 of the size
        let Some(items) = data["answers"].fields["intersections"].fields.get("items") else { continue };
        for item in items.list.iter().filter(|item| item.fields.contains_key("parameter")) {
            let at = |name: &str, rows| de_boor(degree, &knots, rows, number(&item.fields[name].list[1].text));
            let (p, q) = (at("parameter", &rows), at("other parameter", &partner));
            let (v, w) = (p[p.len() - 1], q[q.len() - 1]);
            let apart = p.iter().zip(&q).any(|(x, y)| (x / v - y / w).abs() > 2f64.powi(-40) * size);
            *counts.get_mut("meetings").unwrap() += 1;
            *counts.get_mut("apart").unwrap() += u64::from(apart);
        }
    }
    println!("{}", names.map(|name| format!("{name} {}", counts[name])).join(" "));
}
