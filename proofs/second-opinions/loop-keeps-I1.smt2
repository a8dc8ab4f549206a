; Loop augmentation maintains I-1
; Says: If S is isomorphic to the explored subgraph G_s and the hypothesis h is confirmed for e,
;   then S with the edge e/h is isomorphic to G_s with the edge just walked.
; Paper: V, step 2, last case ('a hypothesis is accepted')
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
;                   with 0: before the pass, with 1: after it, without: left alone by it
;   e, h            the dart explored in this pass, and the hypothesis that was confirmed
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
(declare-fun known (MapDart) Bool)
(declare-fun phi (MapDart) Dart)
(declare-fun name (Dart) MapDart)
(declare-fun next (MapDart) MapDart)
(declare-fun degree_map (MapDart) Degree)
(declare-fun home (MapDart) Bool)
(declare-fun walked0 (Dart) Bool)
(declare-fun explored0 (MapDart) Bool)
(declare-fun open0 (MapDart) Bool)
(declare-fun partner0 (MapDart) MapDart)
(declare-fun walked1 (Dart) Bool)
(declare-fun explored1 (MapDart) Bool)
(declare-fun partner1 (MapDart) MapDart)
(declare-const e MapDart)
(declare-const h MapDart)

; an edge has two ends
(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
; I-1 before: G_s is a subgraph of G
(assert (forall ((d Dart) (c Dart)) (=> (and (seen d) (= (vertex c) (vertex d))) (seen c))))
(assert (forall ((d Dart)) (=> (walked0 d) (and (seen d) (walked0 (alpha d))))))
; I-1 before: phi carries the darts of S one to one to those at vertices of G_s
(assert (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x)))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
; I-1 before: the edge-index condition
(assert (forall ((x MapDart))
  (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x)))))))
; I-1 before: the edges of S are the edges of G_s
(assert (forall ((x MapDart)) (=> (explored0 x) (and (known x) (walked0 (phi x))))))
(assert (forall ((x MapDart)) (=> (and (known x) (walked0 (phi x))) (explored0 x))))
(assert (forall ((x MapDart))
  (=> (explored0 x)
      (and (explored0 (partner0 x)) (= (partner0 (partner0 x)) x)
           (= (phi (partner0 x)) (alpha (phi x)))))))
; I-1 before: S carries the degrees and the marker of G
(assert (forall ((x MapDart))
  (=> (known x)
      (and (= (degree_map x) (degree (phi x))) (= (home x) (marked (phi x)))))))
; I-2 before: a dart of U is at a vertex of S
(assert (forall ((x MapDart)) (=> (open0 x) (known x))))
; the pass: e is taken from U, and the test of h in U proved that e and h are one edge
(assert (open0 e))
(assert (open0 h))
(assert (= (alpha (phi e)) (phi h)))
; the robot has walked that edge
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))))
; loop augmentation: the edge e/h is added to S
(assert (forall ((x MapDart)) (= (explored1 x) (or (explored0 x) (= x e) (= x h)))))
(assert (forall ((x MapDart)) (= (partner1 x) (ite (= x e) h (ite (= x h) e (partner0 x))))))

; not: I-1 after
(assert (not (and
  (forall ((d Dart) (c Dart)) (=> (and (seen d) (= (vertex c) (vertex d))) (seen c)))
  (forall ((d Dart)) (=> (walked1 d) (and (seen d) (walked1 (alpha d)))))
  (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x))))
  (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d))))
  (forall ((x MapDart))
    (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x))))))
  (forall ((x MapDart)) (=> (explored1 x) (and (known x) (walked1 (phi x)))))
  (forall ((x MapDart)) (=> (and (known x) (walked1 (phi x))) (explored1 x)))
  (forall ((x MapDart))
    (=> (explored1 x)
        (and (explored1 (partner1 x)) (= (partner1 (partner1 x)) x)
             (= (phi (partner1 x)) (alpha (phi x))))))
  (forall ((x MapDart))
    (=> (known x)
        (and (= (degree_map x) (degree (phi x))) (= (home x) (marked (phi x)))))))))
(check-sat)
