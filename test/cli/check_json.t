"raylab check --json" is for programs that show mistakes in the text.

  $ header='imWidth 4 imHeight 3 canvWidth 4 canvHeight 3 depth 4'
  $ printf '%s\nsphere 0 0 4 -1 difusive red\n' "$header" > a.scene
  $ printf '%s\ninclude "wood.scene"\nsphere 0 0 4 0 reflective\n' "$header" > b.scene
  $ printf 'sphere 0 0 4 (1 / 0) reflective\n' > wood.scene
  $ printf '%s\nplane 0 -1 0 0 1 0 diffusive 200 9 9\n' "$header" > c.scene
  $ printf '%s\nsphere 0 0 4 1 reflective\n' "$header" > d.scene
  $ raylab check --json a.scene b.scene c.scene d.scene none.scene
  {
    "version": 1,
    "scenes": [
      {
        "scene": "a.scene",
        "problems": [
          {
            "severity": "error",
            "file": "a.scene",
            "line": 2,
            "columns": [ 17, 24 ],
            "message": "unknown surface 'difusive'",
            "remedy": "expected a surface: diffusive, reflective, luminous, glossy, refractive,\nglass, mixed, checker or varying. Did you mean 'diffusive'?"
          }
        ]
      },
      {
        "scene": "b.scene",
        "problems": [
          {
            "severity": "error",
            "file": "b.scene",
            "line": 3,
            "columns": [ 14, 14 ],
            "message": "the radius must be greater than 0, not 0",
            "remedy": ""
          },
          {
            "severity": "error",
            "file": "wood.scene",
            "line": 1,
            "columns": [ 15, 19 ],
            "message": "1 / 0 is not a finite number: it is 1 / 0",
            "remedy": ""
          }
        ]
      },
      {
        "scene": "c.scene",
        "problems": [
          {
            "severity": "warning",
            "file": "c.scene",
            "line": null,
            "columns": null,
            "message": "there is no light: diffusive surfaces are black",
            "remedy": ""
          },
          {
            "severity": "warning",
            "file": "c.scene",
            "line": 2,
            "columns": [ 1, 5 ],
            "message": "plane 1 has the colour 200 9 9, which looks like 0 to 255; from 0 to 1 it is 0.784 0.0353 0.0353 (line 2)",
            "remedy": ""
          }
        ]
      },
      { "scene": "d.scene", "problems": [] },
      {
        "scene": "none.scene",
        "problems": [
          {
            "severity": "error",
            "file": "none.scene",
            "line": null,
            "columns": null,
            "message": "No such file or directory",
            "remedy": ""
          }
        ]
      }
    ]
  }
  [1]

It is valid, and what the manual page says of it holds.

  $ raylab check --json a.scene b.scene c.scene d.scene none.scene > all.json
  [1]
  $ cat > valid.js <<EOF
  > const text = require("fs").readFileSync("all.json", "utf8");
  > const { version, scenes } = JSON.parse(text);
  > const is = (ok, what) => ok || console.log("wrong:", what);
  > is(version === 1, "version");
  > is(scenes.length === 5, "a scene each");
  > for (const { scene, problems } of scenes) {
  >   is(typeof scene === "string", scene);
  >   for (const p of problems) {
  >     is(Object.keys(p).join() === "severity,file,line,columns,message,remedy", p);
  >     is(["error", "warning"].includes(p.severity), p);
  >     is(typeof p.file === "string" && typeof p.message === "string", p);
  >     is(typeof p.remedy === "string" && !p.message.includes("\n"), p);
  >     is((p.line === null) === (p.columns === null), p);
  >     if (p.line) is(p.line >= 1 && p.columns[0] <= p.columns[1], p);
  >   }
  > }
  > EOF
  $ node valid.js
  $ raylab help check | sed -n '/^ *PROBLEM/,/^ *"remedy/p' | grep -o '^[^"]*"[a-z]*":' | grep -o '[a-z]*"' | tr -d '"' | tr '\n' ' '
   severity  file  line  columns  message  remedy 

Warnings leave the exit status alone, and nothing is on standard error.

  $ raylab check --json c.scene 2>&1 > /dev/null
