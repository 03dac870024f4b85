% FITTABLES  One surrogate per response file.
%
% CALL: SURROGATES = fitTables (PLANS, RESPONSES, LIMITS, OPTIONS)
%
% PLANS       text or cellstr: CSV of the plan (n x d), one for all responses
%             or one per response
% RESPONSES   cellstr: CSV of one response each (n rows, NaN: failed); a cell
%             of cells (one per model) is unfolded
% LIMITS      2 x d, limits of the design variables
% OPTIONS     struct of fitSurrogate (trend, covariance)
% SURROGATES  1 x T struct array of fitSurrogate, named KM_fun_1 ...
%
% Errors: DEcalioc:fitTables:missingFile, :badShape
%
% See also: createKrigingModels, fitSurrogate

function surrogates = fitTables (plans, responses, limits, options)
  plans = cellstr (plans);
  responses = unfold (responses);
  for t = 1:numel (responses)
    which = min (t, numel (plans));
    X = readTable (plans{which});
    z = readTable (responses{t});
    if rows (X) ~= rows (z)
      error ('DEcalioc:fitTables:badShape', ...
             'fitTables: %s must have one row per plan row, got %d for %d.', ...
             responses{t}, rows (z), rows (X));
    end
    options.name = sprintf ('KM_fun_%d', t);
    surrogates(t) = fitSurrogate (X, z(:, 1), limits, options);
  end
end

function list = unfold (files)
  list = {};
  if ischar (files)
    files = cellstr (files);
  end
  for i = 1:numel (files)
    if iscell (files{i})
      list = [list, unfold(files{i})];
    else
      list = [list, files(i)];
    end
  end
end

function M = readTable (file)
  if ~exist (file, 'file')
    error ('DEcalioc:fitTables:missingFile', ...
           'fitTables: %s must be a CSV file, it is missing.', file);
  end
  text = fileread (file);
  first = strtok (text, "\n");
  skip = double (any (isletter (regexprep (first, 'NaN|Inf|[eE]', ''))));
  M = dlmread (file, ',', skip, 0, 'emptyvalue', NaN);
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! plan = fullfile (folder, 'plan.csv');
%! z = fullfile (folder, 'z.csv');
%! writeAtomic (plan, "a,b\n0,0\n1,0\n0,1\n1,1\n0.5,0.4\n");
%! writeAtomic (z, "0\n1\n2\n3\n");
%! options = struct ('trend', 'affine', 'covariance', 'matern52');
%! caught = '';
%! try
%!   fitTables (plan, {z}, [0, 0; 1, 1], options);
%! catch err
%!   caught = err.identifier;
%! end
%! writeAtomic (z, "0\n1\n2\n3\n1.3\n");
%! s = fitTables (plan, {{z}}, [0, 0; 1, 1], options);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert (caught, 'DEcalioc:fitTables:badShape');
%! assert (predictSurrogate (s, [0.2, 0.3]), 0.8, 0.01);
%!error id=DEcalioc:fitTables:missingFile
%! fitTables ('no such plan.csv', {'x.csv'}, [0; 1], struct ());
