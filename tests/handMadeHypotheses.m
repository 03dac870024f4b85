% HANDMADEHYPOTHESES  A tiny set of hypotheses with known answers, for tests.
%
% CALL: MODELS = handMadeHypotheses ()
%
%   MODELS  struct as of makeHypotheses: 1 parameter, 4 targets of variance 1,
%           two effects: 'a' moves targets 3 and 4 by 4, 'b' target 4 by -4;
%           the parameter moves targets 1 and 2 by 3 and 1
%
% See also: makeHypotheses, fitLibrary, caseEvidence

function models = handMadeHypotheses ()
  e = struct ('name', {'a', 'b'}, 'powers', [0, 1], 'bend', 1, ...
              'unbent', 0, 'strongest', 1, ...
              'coef', {[0, 0, 4, 4], [0, 0, 0, -4]}, 'range', [0, 1], ...
              'scale', 0.5, 'laboratory', true, 'varPowers', [0, 0], ...
              'varCoef', zeros (1, 4));
  white = struct ('p', 1, 'powers', [0; 1], 'W', eye (4), 'back', eye (4), ...
                  'columns', 1:4, ...
                  'coef', [0, 0, 0, 0; 3, 1, 0, 0], 'varPowers', 0, ...
                  'varCoef', zeros (1, 4), 'nu', Inf (1, 4), 'effect', e, ...
                  'success', zeros (2, 1), 'joint', []);
  white.parity = null ([3, 1, 0, 0]);
  models = struct ('white', white, 'names', {{'a', 'b'}}, ...
                   'siblings', {{{}, {}}});
  models.options = gapOptions (struct ('points', 1000));
  models.prior = struct ('mean', 0, 'sd', Inf);
  kind = struct ('weight', 1, 'white', white, ...
                 'h', newHypothesis ('discrepancy', zeros (1, 0), [1.5, 0.8]));
  kind.white.shape = ones (1, 4);
  models = hypothesisTable (models, kind, [0; 0.7; -0.7]);
  models.reference = [];
end

%!assert (handMadeHypotheses ().white.p, 1)
