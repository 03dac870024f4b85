% HANDMADEMODELS  A tiny set of hypotheses with known answers, for tests.
%
% CALL: MODELS = handMadeModels ()
%
%   MODELS  struct as of makeModels: 1 parameter, 4 targets of unit variance,
%           two effects: 'a' moves targets 3 and 4 by 4, 'b' target 4 by -4;
%           the parameter moves targets 1 and 2 by 3 and 1
%
% See also: makeModels, fitLibrary, weighCase

function models = handMadeModels ()
  e = struct ('name', {'a', 'b'}, 'powers', [0, 1], ...
              'coef', {[0, 0, 4, 4], [0, 0, 0, -4]}, 'range', [0, 1], ...
              'scale', 0.5, 'laboratory', true, 'varPowers', [0, 0], ...
              'varCoef', zeros (1, 4));
  white = struct ('p', 1, 'powers', [0; 1], 'W', eye (4), 'columns', 1:4, ...
                  'coef', [0, 0, 0, 0; 3, 1, 0, 0], 'varPowers', 0, ...
                  'varCoef', zeros (1, 4), 'effect', e);
  models = struct ('white', white, 'names', {{'a', 'b'}}, ...
                   'siblings', {{{}, {}}}, 'nameAt', 0.8, 'level', 0.05, ...
                   'temperature', 1);
  models.prior = struct ('mean', 0, 'precision', 0, 'widen', 1);
  models.weights = struct ('null', 0.4, 'single', 0.4, 'pair', 0.1, ...
                           'unlisted', 0.1);
  models.base = integrationPoints (1000, 3, 1);
  models.noise = integrationPoints (1000, 4, 1).normal;
  models.starts = [0; 0.7; -0.7];
  kind = struct ('name', 'anything', 'weight', 1, 'white', white, ...
                 'shape', ones (1, 4), 'tau', [0.5, 1, 2, 4]);
  kind.white.extra = 4 * ones (1, 4);
  models.kinds = kind;
end

%!assert (handMadeModels ().white.p, 1)
