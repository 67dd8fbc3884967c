let () =
  Alcotest.run "geometry"
    [
      Test_number.suite;
      Test_vec3.suite;
      Test_direction.suite;
      Test_ray.suite;
      Test_box3.suite;
      Test_meeting.suite;
      Test_spot.suite;
      Test_crossings.suite;
      Test_offset.suite;
      Test_similarity.suite;
      Test_sphere.suite;
      Test_sphere_precision.suite;
      Test_plane.suite;
      Test_box.suite;
      Test_frustum.suite;
      Test_torus.suite;
      Test_flat.suite;
      Test_shape.suite;
      Test_placed.suite;
      Test_solid.suite;
      Test_finder.suite;
      Test_bvh_leaves.suite;
      Test_bvh.suite;
      Test_mesh.suite;
    ]
