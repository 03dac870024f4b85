% A case as published runs unchanged, but for what docs/inputs.md lists: each
% row of that table is refused for the reason that stands there, and for no
% other.

%!function names = inTable ()
%!  root = fileparts (fileparts (which ('startToolbox')));
%!  text = fileread (fullfile (root, 'docs', 'inputs.md'));
%!  from = strfind (text, '## A published case');
%!  text = text(from:from + strfind (text(from + 5:end), "\n## ")(1));
%!  names = {};
%!  for row = strsplit (text, "\n")
%!    cells = strsplit (row{1}, '|');
%!    if numel (cells) == 5
%!      found = regexp (cells{3}, '`(\w+)`', 'tokens');
%!      names = [names, found{:}];
%!    end
%!  end
%!endfunction

%!function reasons = reasonsOf (change)
%!  folder = tempname ();
%!  raw = goodPublished (folder);
%!  for k = 1:rows (change)
%!    raw = setIn (raw, change{k, 1}, change{k, 2});
%!  end
%!  p = checkCase (raw);
%!  reasons = strrep ({p.id}, 'DEcalioc:checkCase:', '');
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (folder, 's');
%!endfunction

%!function raw = setIn (raw, path, value)
%!  words = strsplit (path, '.');
%!  if strcmp (words{1}, 'FILE')
%!    file = fullfile (raw.folder, 'DEMmodels', 'Toy', ...
%!                     strjoin (words(2:end), '.'));
%!    fid = fopen (file, 'w');
%!    fputs (fid, value);
%!    fclose (fid);
%!  elseif numel (words) == 1
%!    raw.(words{1}) = value;
%!  else
%!    raw.(words{1}).(words{2}) = value;
%!  end
%!endfunction

%!assert (isempty (reasonsOf (cell (0, 2))))

%!test
%! changes = {{'Input.maxCpu', 8}, 'unknownField'; ...
%!            {'Input.numOfSam', 3}, 'tooFewSamples'; ...
%!            {'optim.targetVal', [400; 0]}, 'zeroTarget'; ...
%!            {'optim.tolRes', [0.01; 1]}, 'badTolRes'; ...
%!            {'optim.targetVal', [400; 1; 2]; ...
%!             'optim.tolRes', [0.1; 0.1; 0.1]}, 'targetCount'; ...
%!            {'assign', {'densityP', 'coefFrictionPX'}}, 'unknownVariable'; ...
%!            {'assign', {'densityP', 'material'}}, 'variableStyle'; ...
%!            {'FILE.in.Toy', ["include data.head\nvariable densityP ", ...
%!                             "equal 7\n"]}, 'overwrittenInScript'; ...
%!            {'assign', {'densityP', 'coefRestitutionPP'}}, ...
%!            'overwrittenVariable'; ...
%!            {'assign', {'densityP', 'SIMTS'}}, 'reservedName'; ...
%!            {'modelVars', struct('radiusP', 2e-3, ...
%!                                 'percentRayleigh', 0.3)}, ...
%!            'missingRayleigh'; ...
%!            {'modelVars.coefRestitutionPP', 1.2}, 'impossibleValue'; ...
%!            {'paramLims', [800, 0.3; 500, 0.7]}, 'badLimits'; ...
%!            {'FILE.runscript', "true\r\n"}, 'windowsLineEnds'; ...
%!            {'FILE.runscript', "noSuchDEM < in.Toy\n"}, 'missingProgram'; ...
%!            {'FILE.runscript', "mpirun -np 4 true\n"}, 'rankMismatch'};
%! for k = 1:rows (changes)
%!   reasons = unique (reasonsOf (changes{k, 1}));
%!   assert (any (strcmp (reasons, changes{k, 2})), ...
%!           [changes{k, 2}, ': ', strjoin(reasons, ' ')]);
%! end
%! assert (sort (inTable ()), sort (changes(:, 2)'));
