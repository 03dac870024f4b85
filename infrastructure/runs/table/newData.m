% NEWDATA  Empty table of finished evaluations.
%
% CALL: DATA = newData (D, T)
% CALL: DATA = newData (D, T, V)
%
% D, T, V  number of design variables, of responses, of effect variables (0)
% DATA     struct. A row (addRows) is one choice of parameter values with one
%          seed, run by every model:
%   X          n x d, parameters
%   E          n x v, effect values (n x 0 in a calibration)
%   Z          n x T, responses; NaN: failed, no result, or not run
%   replicate  n x 1, which packing of these values
%   stage      n x 1 cell: 'plan', 'infill', 'verify', 'replicate', 'repeat' (of a
%              suspect), 'import', 'library'; of a diagnosis also 'gap' and
%              'cure' (to verify, no data of a later start)
%
% New rows come from a handle [Z, BUDGET] = evaluate (P, E, REPLICATE, STAGE,
% BUDGET): NaN where a run failed, NA where Input.maxNewRuns left none.
% newEvaluate makes it of the models of a case, or of a formula
% Z = f (P, E, REPLICATE) of one's own.

function data = newData (d, T, v)
  if nargin < 3
    v = 0;
  end
  data = struct ('X', zeros (0, d), 'E', zeros (0, v), ...
                 'Z', zeros (0, T), 'replicate', zeros (0, 1));
  data.stage = cell (0, 1);
end

%!test
%! data = newData (3, 2);
%! assert ({size(data.X), size(data.Z), size(data.E)}, ...
%!         {[0, 3], [0, 2], [0, 0]});

% SPDX-License-Identifier: GPL-3.0-only
