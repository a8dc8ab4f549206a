(* No smaller pairs, by the extracted search of Minimality.v; and beyond what is computed inside Coq:
   planar simple maps with 8 edges and at most 6 vertices.  Where there are pairs the same search must
   find them: among simple maps with 6 edges, and planar ones with 8 edges and 7 vertices.
   Usage: minimality.  Exit code 1 if one of the answers is not as expected. *)
open Certified

let repeated walk times = List.concat (List.init times (fun _ -> walk))

let up_to m = List.concat (List.init m (fun j -> simple_maps (j + 1)))
let of_size keep maps = List.filter (fun map -> keep (vertices_in map)) maps

let asked = [
  "simple, at most 5 edges", true, (fun () -> told_apart the_same simple_walk (up_to 5));
  "simple, 6 edges", false, (fun () -> told_apart the_same (repeated planar_walk 4) (simple_maps 6));
  "planar simple, at most 7 edges", true, (fun () -> told_apart the_same_at_v0 planar_walk (up_to 7));
  "planar simple, 8 edges, at most 6 vertices", true, (fun () ->
    told_apart the_same_at_v0 (repeated planar_walk 4) (of_size (fun n -> n <= 6) (simple_maps 8)));
  "planar simple, 8 edges, 7 vertices", false, (fun () ->
    told_apart the_same_at_v0 (repeated planar_walk 4) (of_size (fun n -> n = 7) (simple_maps 8))) ]

let () =
  let as_expected (what, expected, ask) =
    let answer = ask () in
    Printf.printf "%s: %s\n%!" what (if answer then "all told apart" else "not all told apart");
    answer = expected in
  exit (if List.for_all Fun.id (List.map as_expected asked) then 0 else 1)
