% Nothing that lies in a store or in another case is carried out.

%!function planted = evil (flag)
%!  planted = ["# Created by Octave\n# name: kinds\n# type: function handle\n", ...
%!             "@<anonymous>\nsystem('touch ", flag, "')\n\n"];
%!endfunction

%!test
%! % an index, a function in the folder where the command is called
%! Case = readyCase ();
%! evaluateDEM ([1, 2; 3, 4], Case);
%! store = Case.store;
%! flag = tempname ();
%! place = fullfile (store, 'optim', 'First');
%! writeAtomic (fullfile (place, 'library.index'), evil (flag));
%! writeAtomic (fullfile (place, sprintf ('.index-%d', geteuid ())), ...
%!              evil (flag));
%! for name = {'strjoin', 'startToolbox', 'fullfile', 'printf', 'readIndex'}
%!   writeAtomic (fullfile (store, [name{1}, '.m']), ...
%!     sprintf (['function varargout = %s (varargin)\nsystem (''touch %s'');\n', ...
%!               'varargout{1} = '''';\nend\n'], name{1}, flag));
%! end
%! [status, out] = startCommand (store, 'runs');
%! assert (status == 0 && ~isempty (strfind (out, '2 runs: 2 ok')), out);
%! [status, out] = startCommand (store, 'forget . First 1');
%! assert (status == 0 && ~isempty (strfind (out, '1 run of First')), out);
%! assert (! isfile (flag));
%! % in a case the toolbox says so
%! writeLoadInput (Case.folder);
%! cellfun (@(n) unlink (fullfile (store, n)), {'strjoin.m', ...
%!   'startToolbox.m', 'fullfile.m', 'printf.m'}, 'UniformOutput', false);
%! [status, out] = startCommand (Case.folder, 'check');
%! assert (status == 1 && ~isempty (strfind (out, 'file readIndex.m')), out);

%!test
%! % surrogates of a similar bench
%! Case = readyCase ();
%! other = tempname ();
%! [~, ~] = mkdir (fullfile (other, 'results', 'surrogates'));
%! writeAtomic (fullfile (other, 'results', 'calibration.json'), ...
%!              '{"params": {"a": 1, "b": 2}}');
%! flag = tempname ();
%! writeAtomic (fullfile (other, 'results', 'surrogates', 'KM_fun_1.txt'), ...
%!              strrep (evil (flag), 'kinds', 'kept'));
%! Case.options.similar = other;
%! caught = '';
%! try
%!   withEarlier (struct (), Case);
%! catch err
%!   caught = err.identifier;
%! end
%! assert (caught, 'DEcalioc:loadSurrogate:badFile');
%! assert (! isfile (flag));

% SPDX-License-Identifier: GPL-3.0-only
