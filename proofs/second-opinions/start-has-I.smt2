; I-1 and I-2 are true before the loop is entered
; Says: S is the vertex v0, U all its darts; G_s is the vertex phi(v0) with no edge walked.
; Paper: V, step 1
; Symbols:
;   Dart, MapDart   the darts of the world G; the darts of the map S
;   Vertex, Degree  vertices of G; degrees, compared only
;   sigma, next     the next dart clockwise, in G; in S
;   alpha, partner  the other end of the same edge, in G; in S, for explored darts
;   vertex          the vertex of a dart of G
;   degree, marked  the percept in a dart of G;  degree_map, home: the same, recorded in S
;   seen, walked    G_s, the explored subgraph: darts at its vertices, darts of its edges
;   known, explored the same of S: darts at its vertices, darts of its edges
;   open            the set U
;   phi, name       the isomorphism from S to G_s, and its inverse
;   fresh           the dart of S that stands for a dart of G
;   start           the dart that the robot faces at the start
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Vertex 0)
(declare-sort Degree 0)
(declare-fun sigma (Dart) Dart)
(declare-fun alpha (Dart) Dart)
(declare-fun vertex (Dart) Vertex)
(declare-fun degree (Dart) Degree)
(declare-fun marked (Dart) Bool)
(declare-fun seen (Dart) Bool)
(declare-fun walked (Dart) Bool)
(declare-fun known (MapDart) Bool)
(declare-fun explored (MapDart) Bool)
(declare-fun open (MapDart) Bool)
(declare-fun phi (MapDart) Dart)
(declare-fun name (Dart) MapDart)
(declare-fun next (MapDart) MapDart)
(declare-fun partner (MapDart) MapDart)
(declare-fun degree_map (MapDart) Degree)
(declare-fun home (MapDart) Bool)
(declare-fun fresh (Dart) MapDart)
(declare-const start Dart)

; the next dart clockwise is at the same vertex
(assert (forall ((d Dart)) (= (vertex (sigma d)) (vertex d))))
; degree and marker are those of the vertex
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (degree c) (degree d)))))
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (marked c) (marked d)))))
; G_s is the start vertex, without an edge
(assert (forall ((d Dart)) (= (seen d) (= (vertex d) (vertex start)))))
(assert (forall ((d Dart)) (not (walked d))))
; S is one vertex with as many darts, numbered clockwise
(assert (forall ((x MapDart))
  (= (known x) (exists ((d Dart)) (and (= (vertex d) (vertex start)) (= x (fresh d)))))))
(assert (forall ((d Dart))
  (=> (= (vertex d) (vertex start))
      (and (= (phi (fresh d)) d) (= (next (fresh d)) (fresh (sigma d)))))))
(assert (forall ((d Dart)) (= (name d) (fresh d))))
(assert (forall ((x MapDart)) (not (explored x))))
; the percept at the start is recorded
(assert (forall ((x MapDart)) (= (degree_map x) (degree start))))
(assert (forall ((x MapDart)) (= (home x) (marked start))))
; U is all of its darts
(assert (forall ((x MapDart)) (= (open x) (known x))))

; not: I-1 and I-2
(assert (not (and
  (forall ((d Dart) (c Dart)) (=> (and (seen d) (= (vertex c) (vertex d))) (seen c)))
  (forall ((d Dart)) (=> (walked d) (and (seen d) (walked (alpha d)))))
  (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x))))
  (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d))))
  (forall ((x MapDart))
    (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x))))))
  (forall ((x MapDart)) (=> (explored x) (and (known x) (walked (phi x)))))
  (forall ((x MapDart)) (=> (and (known x) (walked (phi x))) (explored x)))
  (forall ((x MapDart))
    (=> (explored x)
        (and (explored (partner x)) (= (partner (partner x)) x)
             (= (phi (partner x)) (alpha (phi x))))))
  (forall ((x MapDart))
    (=> (known x)
        (and (= (degree_map x) (degree (phi x))) (= (home x) (marked (phi x))))))
  (forall ((x MapDart)) (=> (open x) (and (known x) (not (walked (phi x))))))
  (forall ((d Dart)) (=> (and (seen d) (not (walked d))) (open (name d)))))))
(check-sat)
