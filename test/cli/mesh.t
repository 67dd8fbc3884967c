Meshes from files. test/mesh_file tells what is in these, test/language/test_mesh.ml
what they mean in a scene.

  $ mkdir -p house shared
  $ cat > shared/roof.obj <<EOF
  > v -1 0 4
  > v 1 0 4
  > v 0 1 4
  > f 1 3 2
  > EOF
  $ cat > scene <<EOF
  > imWidth 16 imHeight 12 canvWidth 4 canvHeight 3 depth 4
  > directional 1 white 1 -1 1
  > plane 0 -1 0   0 1 0   diffusive white
  > EOF
  $ (cat scene; echo 'mesh "../shared/roof.obj" diffusive red') > house/main.scene

They are in the folder of the scene or below it, or in one that is allowed.

  $ raylab check house/main.scene
  house/main.scene:4:6-25: error: '../shared/roof.obj' cannot be read: it lies outside of the folder of the scene
      4 | mesh "../shared/roof.obj" diffusive red
        |      ^^^^^^^^^^^^^^^^^^^^
  if it may be read, say so: --allow and the folder in which it is
  [1]
  $ raylab explain house/main.scene 8,5 --allow shared | head -n 5
  pixel (8, 5) is rgb 147 0 0: the face 1 (line 4 of ../shared/roof.obj) of a
  red mesh (object 2, line 4), lit by light 1
  
  ray 1: (0, 0, -4) + t (0.0312195, 0.0312195, 0.999025), 4 left in the chain
    hits the face 1 (line 4 of ../shared/roof.obj) of mesh 2 (line 4)

A device and a folder are no meshes.

  $ mkdir house/folder.ply && ln -s /dev/zero house/zero.stl
  $ (cat scene; echo 'mesh "folder.ply" reflective mesh "zero.stl" reflective') > house/x.scene
  $ raylab check house/x.scene --allow /dev
  house/x.scene:4:6-17: error: 'folder.ply' cannot be read: it is a folder, not a file
      4 | mesh "folder.ply" reflective mesh "zero.stl" reflective
        |      ^^^^^^^^^^^^
  house/x.scene:4:35-44: error: 'zero.stl' cannot be read: it is a device, not a file
      4 | mesh "folder.ply" reflective mesh "zero.stl" reflective
        |                                   ^^^^^^^^^^
  [1]

What there is to know of a mesh, "raylab check" tells. Two readers may want that.

  $ (cat scene; echo 'mesh "../shared/roof.obj" smooth reflective mesh "../shared/roof.obj" reflective') > house/x.scene
  $ raylab check house/x.scene --allow shared
  house/x.scene: warning: mesh 3 is where mesh 2 is: they hide each other (lines 4 and 4)
  house/x.scene: mesh ../shared/roof.obj: 1 triangle from (-1, 0, 4) to (1, 1, 4), open: face 1 (line 4 of ../shared/roof.obj) has an edge from (-1, 0, 4) to (0, 1, 4) that no other face has; most of its normals point along (0, 0, -1)
  $ raylab check house/x.scene --allow shared --json
  {
    "version": 1,
    "scenes": [
      {
        "scene": "house/x.scene",
        "problems": [
          {
            "severity": "warning",
            "file": "house/x.scene",
            "line": 4,
            "columns": [ 1, 4 ],
            "message": "mesh 3 is where mesh 2 is: they hide each other (lines 4 and 4)",
            "remedy": ""
          }
        ],
        "meshes": [
          {
            "file": "../shared/roof.obj",
            "triangles": 1,
            "low": [ -1.0, 0.0, 4.0 ],
            "high": [ 1.0, 1.0, 4.0 ],
            "open": "face 1 (line 4 of ../shared/roof.obj) has an edge from (-1, 0, 4) to (0, 1, 4) that no other face has",
            "normals": [ 0.0, 0.0, -1.0 ]
          }
        ]
      }
    ]
  }

A scene that is printed reads back, and so does its picture.

  $ cp shared/roof.obj house && (cat scene; echo 'mesh "roof.obj" smooth diffusive red scaled 2') > house/main.scene
  $ raylab check --expand house/main.scene > house/expanded.scene
  $ tail -n 1 house/expanded.scene
  mesh "roof.obj" smooth diffusive 1 0 0 scaled 2  # line 4
  $ for scene in main expanded; do raylab render -q house/$scene.scene -o $scene.png; done
  $ cmp main.png expanded.png

A change of a mesh makes another picture: bands of the two are not joined.

  $ raylab render -q house/main.scene --rows 0-5 -o a.ppm
  $ sed -i 's/v 0 1 4/v 0 1.5 4/' house/roof.obj
  $ raylab render -q house/main.scene --rows 6-11 -o b.ppm
  $ raylab join a.ppm b.ppm -o joined.png
  raylab: a.ppm and b.ppm are not of one picture: the scenes differ
  [1]

The folder of a job has copies, wherever they come from.

  $ (cat scene; echo 'mesh "../shared/roof.obj" diffusive red mesh "roof.obj" reflective') > house/main.scene
  $ raylab slurm house/main.scene --allow shared -o job.png --bands 2 2> /dev/null
  $ tail -n 1 job.slurm/picture.scene
  mesh "included/1/roof.obj" diffusive red mesh "roof.obj" reflective
  $ cmp house/roof.obj job.slurm/roof.obj
  $ cmp shared/roof.obj job.slurm/included/1/roof.obj
  $ raylab check job.slurm/picture.scene
  job.slurm/picture.scene: mesh included/1/roof.obj: 1 triangle from (-1, 0, 4) to (1, 1, 4), open: face 1 (line 4 of included/1/roof.obj) has an edge from (-1, 0, 4) to (0, 1, 4) that no other face has; most of its normals point along (0, 0, -1)
  job.slurm/picture.scene: mesh roof.obj: 1 triangle from (-1, 0, 4) to (1, 1.5, 4), open: face 1 (line 4 of roof.obj) has an edge from (-1, 0, 4) to (0, 1.5, 4) that no other face has; most of its normals point along (0, 0, -1)

The name of a file controls no terminal.

  $ cp house/roof.obj "house/$(printf 'r\033[31m.obj')"
  $ (cat scene; printf 'mesh "r\033[31m.obj" diffusive red') > house/main.scene
  $ raylab explain house/main.scene 8,5 | head -n 2 | grep -c "$(printf '\033')"
  0
  [1]
  $ raylab check --expand house/main.scene > house/expanded.scene && raylab check house/expanded.scene
  house/expanded.scene: mesh r�[31m.obj: 1 triangle from (-1, 0, 4) to (1, 1.5, 4), open: face 1 (line 4 of r�[31m.obj) has an edge from (-1, 0, 4) to (0, 1.5, 4) that no other face has; most of its normals point along (0, 0, -1)

No picture replaces a mesh of the scene.

  $ (cat scene; echo 'mesh "roof.obj" diffusive red') > house/main.scene
  $ ln house/roof.obj house/roof.png
  $ raylab render house/main.scene -o house/roof.png
  raylab: house/roof.png is a file of the scene; the picture would replace it
  [124]
