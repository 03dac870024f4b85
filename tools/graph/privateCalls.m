% PRIVATECALLS  Programs outside infrastructure/ that call a private function.
%
% CALL: faults = privateCalls (root, names)
%
% root    folder of the toolbox (text)
% names   names of the private functions of infrastructure/ (cell, n x 1)
% faults  a line for each program and function (cell, 1 x m)
%
% A program of benchmarks/, tests/, tools/, examples/, a model or a template finds no
% private function: it ends there, perhaps after hours. A name that the program
% defines itself is its own.

function faults = privateCalls (root, names)
  faults = {};
  for file = programs (root)'
    text = regexprep (fileread (file{1}), '^\s*%(?!!).*$', '', 'lineanchors', ...
                      'dotexceptnewline');
    own = regexp (text, 'function\s+(?:[^=\n]*=\s*)?(\w+)', 'tokens');
    called = regexp (text, '(?<![\w.''"])@?([a-zA-Z]\w*)(?= \(|;)', 'tokens');
    bad = setdiff (intersect ([called{:}, {}], names), [own{:}, {}]);
    where = strrep (file{1}, [root, '/'], '');
    faults = [faults, strcat({['Private: ', where, ' calls ']}, bad(:)')];
  end
end

function files = programs (root)
  files = {};
  for part = {'benchmarks', 'tests', 'tools', 'examples', 'templates', 'DEMmodels'}
    for folder = strsplit (genpath (fullfile (root, part{1})), pathsep ())
      files = [files; glob(fullfile (folder{1}, {'*.m', '*.tst'}))];
    end
  end
end

%!test
%! root = tempname ();
%! mkdir (root);
%! mkdir (fullfile (root, 'benchmarks'));
%! write = @(name, text) writeAtomic (fullfile (root, 'benchmarks', name), text);
%! write ('calls.m', "% hidden (1) in a comment\nx = hidden (1);\n");
%! write ('handle.m', "f = @hidden;\n");
%! write ('own.m', "function y = hidden (x)\n  y = x;\nend\nhidden (1)\n");
%! write ('field.m', "s.hidden (1) = 2;\nt = 'hidden (1)';\n");
%! write ('test.tst', "%!test\n%! hidden (1);\n");
%! faults = privateCalls (root, {'hidden'; 'other'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (root, 's');
%! assert (faults, strcat ({'Private: benchmarks/'}, ...
%!                         {'calls.m', 'handle.m', 'test.tst'}, {' calls hidden'}));
