// The manual of the language is written in Markdown: headings, paragraphs, lists, tables, code. All text stays text.

import { make } from "./dom.js";

/** `code`, **strong**, *emphasis* and [links](…) inside a paragraph; a link's text stays. */
function inline(text) {
  const parts = [];
  let at = 0;
  for (const match of text.matchAll(/`([^`]+)`|\*\*([^*]+)\*\*|\[([^\]]+)\]\([^)]*\)|\*([^\s*][^*]*)\*/g)) {
    parts.push(text.slice(at, match.index));
    if (match[1] !== undefined) parts.push(make("code", {}, match[1]));
    else if (match[2] !== undefined) parts.push(make("strong", {}, ...inline(match[2])));
    else parts.push(match[4] !== undefined ? make("em", {}, ...inline(match[4])) : match[3]);
    at = match.index + match[0].length;
  }
  parts.push(text.slice(at));
  return parts.filter((part) => part !== "");
}

/** The cells of a row; a bar behind a backslash or in code belongs to its cell. */
function cells(line) {
  const found = [""];
  let code = false;
  const inner = line.trim().replace(/^\|/, "").replace(/\|$/, "");
  for (let i = 0; i < inner.length; i++) {
    const c = inner[i];
    if (c === "`") code = !code;
    if (c === "\\" && inner[i + 1] === "|") {
      found[found.length - 1] += "|";
      i++;
    } else if (c === "|" && !code) found.push("");
    else found[found.length - 1] += c;
  }
  return found.map((cell) => cell.trim());
}

/** Elements for a text. */
export function markdown(text) {
  const lines = text.split("\n");
  const out = [];
  let i = 0;
  const take = (fits) => {
    const from = i;
    while (i < lines.length && fits(lines[i])) i++;
    return lines.slice(from, i);
  };
  while (i < lines.length) {
    const line = lines[i];
    const heading = /^(#{1,6}) (.*)/.exec(line);
    if (!line.trim()) i++;
    else if (line.startsWith("```")) {
      i++;
      const code = take((l) => !l.startsWith("```"));
      i++;
      out.push(make("pre", { tabIndex: 0 }, code.join("\n")));
    } else if (heading) {
      i++;
      out.push(make(`h${Math.min(6, heading[1].length + 2)}`, {}, ...inline(heading[2])));
    } else if (line.startsWith("|")) {
      const [head, , ...rows] = take((l) => l.startsWith("|")).map(cells);
      out.push(make("div", { class: "scroll" }, make("table", {},
        make("thead", {}, make("tr", {}, head.map((cell) => make("th", { scope: "col" }, ...inline(cell))))),
        make("tbody", {}, rows.map((row) => make("tr", {}, row.map((cell) => make("td", {}, ...inline(cell)))))))));
    } else if (/^\s*([-*]|\d+\.) /.test(line)) {
      const items = [];
      for (const l of take((l) => l.trim() && (/^\s*([-*]|\d+\.) /.test(l) || /^\s/.test(l)))) {
        if (/^\s*([-*]|\d+\.) /.test(l)) items.push(l.replace(/^\s*([-*]|\d+\.) /, ""));
        else items[items.length - 1] += ` ${l.trim()}`;
      }
      out.push(make(/^\s*\d/.test(line) ? "ol" : "ul", {}, items.map((item) => make("li", {}, ...inline(item)))));
    } else {
      out.push(make("p", {}, ...inline(take((l) => l.trim() && !/^(#|\||```)/.test(l)).join(" "))));
    }
  }
  return out;
}
