// node colour.js GRAMMAR SCENE: the parts of each line that have a colour, as an
// editor finds them: the first match wins, and of several at one place the first
// pattern.
const fs = require("fs");
const grammar = JSON.parse(fs.readFileSync(process.argv[2], "utf8"));

const regex = (text) => {
  const plain = text.replace(/^\(\?i\)/, "");
  return new RegExp(plain, plain === text ? "g" : "gi");
};

const resolve = (patterns) =>
  patterns.flatMap((p) =>
    p.include ? resolve(grammar.repository[p.include.slice(1)].patterns) : [p]
  );

const found = (text, at, line) => {
  const r = regex(text);
  r.lastIndex = at;
  return r.exec(line);
};

const open = [{ patterns: grammar.patterns }];
for (const line of fs.readFileSync(process.argv[3], "utf8").split("\n")) {
  for (let at = 0; at < line.length; ) {
    const inner = open[open.length - 1];
    let best = inner.end && found(inner.end, at, line);
    let pattern = null;
    for (const p of resolve(inner.patterns)) {
      const m = found(p.match || p.begin, at, line);
      if (m && (!best || m.index < best.index)) [best, pattern] = [m, p];
    }
    if (!best) break;
    if (!pattern) open.pop();
    else if (pattern.begin) open.push(pattern);
    else if (pattern.name) console.log(pattern.name, best[0]);
    else
      for (const k in pattern.captures)
        console.log(pattern.captures[k].name, best[k]);
    at = best.index + Math.max(1, best[0].length);
  }
}
