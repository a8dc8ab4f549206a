; Non-loop augmentation maintains I-1
; Says: If S is isomorphic to the explored subgraph G_s and e leads to a vertex outside G_s, then
;   S with a new vertex and the edge e is isomorphic to G_s with that vertex and that edge.
; Paper: V, step 2 ('In the case that no hypothesis exists or ...')
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
;                   a name with 0: before the pass, with 1: after it
;   e, entry        the dart explored in this pass; the new dart of S that the robot came in by
;   new, fresh      the darts that the new vertex adds to S; the one that stands for a dart of G
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
(declare-fun seen0 (Dart) Bool)
(declare-fun walked0 (Dart) Bool)
(declare-fun known0 (MapDart) Bool)
(declare-fun explored0 (MapDart) Bool)
(declare-fun open0 (MapDart) Bool)
(declare-fun phi0 (MapDart) Dart)
(declare-fun name0 (Dart) MapDart)
(declare-fun next0 (MapDart) MapDart)
(declare-fun partner0 (MapDart) MapDart)
(declare-fun degree_map0 (MapDart) Degree)
(declare-fun home0 (MapDart) Bool)
(declare-fun seen1 (Dart) Bool)
(declare-fun walked1 (Dart) Bool)
(declare-fun known1 (MapDart) Bool)
(declare-fun explored1 (MapDart) Bool)
(declare-fun phi1 (MapDart) Dart)
(declare-fun name1 (Dart) MapDart)
(declare-fun next1 (MapDart) MapDart)
(declare-fun partner1 (MapDart) MapDart)
(declare-fun degree_map1 (MapDart) Degree)
(declare-fun home1 (MapDart) Bool)
(declare-fun new (MapDart) Bool)
(declare-fun fresh (Dart) MapDart)
(declare-const e MapDart)
(declare-const entry MapDart)

; an edge has two ends
(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
; the next dart clockwise is at the same vertex
(assert (forall ((d Dart)) (= (vertex (sigma d)) (vertex d))))
; degree and marker are those of the vertex
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (degree c) (degree d)))))
(assert (forall ((c Dart) (d Dart)) (=> (= (vertex c) (vertex d)) (= (marked c) (marked d)))))
; I-1 before: G_s is a subgraph of G
(assert (forall ((d Dart) (c Dart)) (=> (and (seen0 d) (= (vertex c) (vertex d))) (seen0 c))))
(assert (forall ((d Dart)) (=> (walked0 d) (and (seen0 d) (walked0 (alpha d))))))
; I-1 before: phi carries the darts of S one to one to those at vertices of G_s
(assert (forall ((x MapDart)) (=> (known0 x) (and (seen0 (phi0 x)) (= (name0 (phi0 x)) x)))))
(assert (forall ((d Dart)) (=> (seen0 d) (and (known0 (name0 d)) (= (phi0 (name0 d)) d)))))
; I-1 before: the edge-index condition
(assert (forall ((x MapDart))
  (=> (known0 x) (and (known0 (next0 x)) (= (phi0 (next0 x)) (sigma (phi0 x)))))))
; I-1 before: the edges of S are the edges of G_s
(assert (forall ((x MapDart)) (=> (explored0 x) (and (known0 x) (walked0 (phi0 x))))))
(assert (forall ((x MapDart)) (=> (and (known0 x) (walked0 (phi0 x))) (explored0 x))))
(assert (forall ((x MapDart))
  (=> (explored0 x)
      (and (explored0 (partner0 x)) (= (partner0 (partner0 x)) x)
           (= (phi0 (partner0 x)) (alpha (phi0 x)))))))
; I-1 before: S carries the degrees and the marker of G
(assert (forall ((x MapDart))
  (=> (known0 x)
      (and (= (degree_map0 x) (degree (phi0 x))) (= (home0 x) (marked (phi0 x)))))))
; I-2 before: a dart of U is at a vertex of S
(assert (forall ((x MapDart)) (=> (open0 x) (known0 x))))
; the pass: e is taken from U, and its other end is at a vertex that is not in G_s
; (all tests failed, see rejected-means-new)
(assert (open0 e))
(assert (not (seen0 (alpha (phi0 e)))))
; that vertex and that edge join G_s
(assert (forall ((d Dart))
  (= (seen1 d) (or (seen0 d) (= (vertex d) (vertex (alpha (phi0 e))))))))
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi0 e)) (= d (alpha (phi0 e)))))))
; non-loop augmentation: S gets as many new darts as the new vertex has, numbered clockwise
(assert (forall ((x MapDart))
  (= (new x) (exists ((d Dart)) (and (= (vertex d) (vertex (alpha (phi0 e)))) (= x (fresh d)))))))
(assert (forall ((d Dart)) (=> (= (vertex d) (vertex (alpha (phi0 e)))) (= (phi1 (fresh d)) d))))
(assert (= entry (fresh (alpha (phi0 e)))))
(assert (forall ((x MapDart)) (= (known1 x) (or (known0 x) (new x)))))
(assert (forall ((x MapDart)) (=> (known0 x) (= (phi1 x) (phi0 x)))))
(assert (forall ((d Dart)) (= (name1 d) (ite (seen0 d) (name0 d) (fresh d)))))
(assert (forall ((x MapDart)) (=> (known0 x) (= (next1 x) (next0 x)))))
(assert (forall ((d Dart))
  (=> (= (vertex d) (vertex (alpha (phi0 e)))) (= (next1 (fresh d)) (fresh (sigma d))))))
; the edge e/entry is added
(assert (forall ((x MapDart)) (= (explored1 x) (or (explored0 x) (= x e) (= x entry)))))
(assert (forall ((x MapDart))
  (= (partner1 x) (ite (= x e) entry (ite (= x entry) e (partner0 x))))))
; the percept sensed on arrival is recorded at the new vertex
(assert (forall ((x MapDart))
  (= (degree_map1 x) (ite (new x) (degree (alpha (phi0 e))) (degree_map0 x)))))
(assert (forall ((x MapDart)) (= (home1 x) (ite (new x) (marked (alpha (phi0 e))) (home0 x)))))

; not: I-1 after
(assert (not (and
  (forall ((d Dart) (c Dart)) (=> (and (seen1 d) (= (vertex c) (vertex d))) (seen1 c)))
  (forall ((d Dart)) (=> (walked1 d) (and (seen1 d) (walked1 (alpha d)))))
  (forall ((x MapDart)) (=> (known1 x) (and (seen1 (phi1 x)) (= (name1 (phi1 x)) x))))
  (forall ((d Dart)) (=> (seen1 d) (and (known1 (name1 d)) (= (phi1 (name1 d)) d))))
  (forall ((x MapDart))
    (=> (known1 x) (and (known1 (next1 x)) (= (phi1 (next1 x)) (sigma (phi1 x))))))
  (forall ((x MapDart)) (=> (explored1 x) (and (known1 x) (walked1 (phi1 x)))))
  (forall ((x MapDart)) (=> (and (known1 x) (walked1 (phi1 x))) (explored1 x)))
  (forall ((x MapDart))
    (=> (explored1 x)
        (and (explored1 (partner1 x)) (= (partner1 (partner1 x)) x)
             (= (phi1 (partner1 x)) (alpha (phi1 x))))))
  (forall ((x MapDart))
    (=> (known1 x)
        (and (= (degree_map1 x) (degree (phi1 x))) (= (home1 x) (marked (phi1 x)))))))))
(check-sat)
