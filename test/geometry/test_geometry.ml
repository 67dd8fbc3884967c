let () =
  Alcotest.run "geometry"
    [
      Test_number.suite;
      Test_vec3.suite;
      Test_direction.suite;
      Test_ray.suite;
      Test_sphere.suite;
      Test_sphere_precision.suite;
      Test_plane.suite;
      Test_shape.suite;
      Test_query.suite;
      Test_bvh.suite;
    ]
