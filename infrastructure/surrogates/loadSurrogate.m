% LOADSURROGATE  Reads a surrogate that saveSurrogate wrote.
%
% CALL: SURROGATE = loadSurrogate (FILE)
%
% FILE       char, path; SURROGATE  scalar struct of fitSurrogate
%
% The file may be of another user (Input.similar): it is read as texts and
% numbers, of which the sizes are checked, and nothing in it is evaluated.
% Octave's own load would do that with a function handle.
%
% Errors: DEcalioc:loadSurrogate:missingFile, DEcalioc:loadSurrogate:badFile

function surrogate = loadSurrogate (file)
  if ~exist (file, 'file')
    error ('DEcalioc:loadSurrogate:missingFile', ...
           ['loadSurrogate: %s must be a file of createKrigingModels, ' ...
            'it is missing.'], file);
  end
  kept = readOctaveText (file);
  fault = faultOf (kept);
  if ~isempty (fault)
    error ('DEcalioc:loadSurrogate:badFile', ...
           ['loadSurrogate: %s must be a surrogate that DEcalioc wrote, ' ...
            'got %s. Calibrate the case it belongs to once more, which ' ...
            'writes it anew.'], file, fault);
  end
  kept.extra = givenField (kept, 'level', []);
  surrogate = conditionSurrogate (kept, kept);
end

% '' where all is there and fits together.
function fault = faultOf (kept)
  fault = '';
  names = {'name', 'X', 'z', 'limits', 'trend', 'covariance', 'param', ...
           'lognoisevariance', 'shift', 'scale'};
  bad = names(~isfield (kept, names));
  if ~isempty (bad)
    fault = ['none named ', bad{1}];
    return
  end
  isText = cellfun (@(n) ischar (kept.(n)), names);
  isShape = isnumeric (kept.trend);
  bad = names(isText ~= ismember (names, {'name', 'trend', 'covariance'}) & ...
              ~(isShape & strcmp (names, 'trend')));
  if ~isempty (bad)
    fault = ['another kind of ', bad{1}];
  elseif isShape && ~isequal (size (kept.trend), [columns(kept.X), 2])
    fault = 'a known trend of other parameters';
  elseif ~(isShape || any (strcmp (kept.trend, {'constant', 'affine', 'quadratic'}))) || ...
         isempty (regexp (kept.covariance, ...
                          '^(matern(32|52)?|gauss|exp|sph)(_iso)?$'))
    fault = ['the trend ', num2str(kept.trend), ' and the covariance ', ...
             kept.covariance];
  elseif ~fits (kept)
    fault = sprintf ('sizes that do not fit (%d runs, %d parameters)', ...
                     size (kept.X));
  elseif ~isSane (kept)
    fault = 'numbers that no fit gives';
  end
end

function yes = fits (kept)
  [n, d] = size (kept.X);
  extra = givenField (kept, 'level', []);
  v = columns (extra);
  law = givenField (kept, 'noiseLaw', []);
  sizes = [numel(kept.z), columns(kept.limits), ...
           numel(kept.shift), numel(kept.scale), numel(kept.param)];
  model = krigingModel (kept.trend, kept.covariance, d + v);
  yes = n > 0 && isequal (sizes, [n, d, 1, 1, numel(model.param)]) && ...
        any (rows (kept.limits) == 2:4) && ...          % see toUnit
        any (numel (kept.lognoisevariance) == [1, n]) && ...
        (v == 0 || rows (extra) == n) && any (numel (law) == [0, 2]) && ...
        any (numel (givenField (kept, 'scatter', [])) == [0, 2]);
end

function yes = isSane (kept)
  numbers = [kept.X(:); kept.z(:); kept.limits(:); kept.param(:); ...
             kept.shift; kept.scale; givenField(kept, 'scatter', [])(:)];
  [lo, isLog] = deal (kept.limits(1, :), any (kept.limits(3:min (3, end), :), 1));
  yes = all (isfinite (numbers)) && all (kept.limits(2, :) > lo) && ...
        all (lo(isLog) > 0) && kept.scale > 0;
end

%!error id=DEcalioc:loadSurrogate:missingFile loadSurrogate ('no such file');
%!test
%! % of another form, changed, hostile
%! rand ('twister', 1);
%! X = rand (10, 2);
%! file = tempname ();
%! saveSurrogate (file, fitSurrogate (X, X * [1; 2], [0, 0; 1, 1]));
%! text = fileread (file);
%! flag = tempname ();
%! evil = ["# name: kept\n# type: function handle\n@<anonymous>\n", ...
%!         "system('touch ", flag, "')\n\n"];
%! bad = {'', 'rubbish', evil, text(1:end / 2), ...
%!        strrep(text, 'affine', 'affino'), ...
%!        strrep(text, '# rows: 10', '# rows: 9'), ...
%!        strrep(text, '# columns: 2', '# columns: 3'), ...
%!        strrep(text, 'type: scalar', 'type: bool'), ...
%!        regexprep(text, '# name: z\n', "# name: y\n")};
%! for k = 1:numel (bad)
%!   writeAtomic (file, bad{k});
%!   caught = '';
%!   try
%!     loadSurrogate (file);
%!   catch err
%!     caught = err.identifier;
%!   end
%!   assert (caught, 'DEcalioc:loadSurrogate:badFile');
%! end
%! assert (! isfile (flag));

% SPDX-License-Identifier: GPL-3.0-only
