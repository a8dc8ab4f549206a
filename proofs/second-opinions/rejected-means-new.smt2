; If e leads to a known vertex, a true hypothesis is in U
; Says: If the other end of e is at a vertex of G_s, then it is the dart that some h in U stands
;   for; h is not e, and it has the signature sensed at v_u, so it is tested; a true hypothesis
;   matches (truth-matches). Hence, if all hypotheses are rejected, v_u is not in G_s.
; Paper: V, step 2 ('if ... all the hypotheses are rejected ...')
; Symbols:
;   Dart, MapDart   the darts of the world G; the darts of the map S
;   Vertex, Degree  vertices of G; degrees, compared only
;   alpha, partner  the other end of the same edge, in G; in S, for explored darts
;   degree, marked  the percept in a dart of G;  degree_map, home: the same, recorded in S
;   seen, walked    G_s, the explored subgraph: darts at its vertices, darts of its edges
;   known, explored the same of S: darts at its vertices, darts of its edges
;   open            the set U
;   phi, name       the isomorphism from S to G_s, and its inverse
;   e               the dart explored in this pass
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Degree 0)
(declare-fun alpha (Dart) Dart)
(declare-fun degree (Dart) Degree)
(declare-fun marked (Dart) Bool)
(declare-fun seen (Dart) Bool)
(declare-fun walked (Dart) Bool)
(declare-fun known (MapDart) Bool)
(declare-fun open (MapDart) Bool)
(declare-fun phi (MapDart) Dart)
(declare-fun name (Dart) MapDart)
(declare-fun degree_map (MapDart) Degree)
(declare-fun home (MapDart) Bool)
(declare-const e MapDart)

; an edge has two ends
(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
; and they are two darts
(assert (forall ((d Dart)) (not (= (alpha d) d))))
(assert (forall ((d Dart)) (=> (walked d) (and (seen d) (walked (alpha d))))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
; I-1: S carries the degrees and the marker of G
(assert (forall ((x MapDart))
  (=> (known x)
      (and (= (degree_map x) (degree (phi x))) (= (home x) (marked (phi x)))))))
; I-2: phi carries U one to one to the unexplored darts at vertices of G_s
(assert (forall ((x MapDart)) (=> (open x) (and (known x) (not (walked (phi x)))))))
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked d))) (open (name d)))))
; the pass: e is taken from U, and its other end is at a vertex of G_s
(assert (open e))
(assert (seen (alpha (phi e))))

; not: some h in U, other than e and of the signature sensed, is true
(assert (not (exists ((h MapDart))
  (and (open h) (not (= h e)) (= (phi h) (alpha (phi e)))
       (= (degree_map h) (degree (alpha (phi e)))) (= (home h) (marked (alpha (phi e))))))))
(check-sat)
